// The eye as seen from a point.
// Twin of src/reference/camera/eye.rs.

// uses: math/vec

// The direction to the eye, and the pixel that sees the point.
struct EyeSample {
    // Towards the eye, of unit length.
    vec3 wi;
    float distance;
    // The point is within the picture as the eye sees it.
    bool seen;
    // Row 0 is at the top.
    uint column;
    uint row;
    // See eye_importance.
    float importance;
};

// The factor with which radiance * cosine at the point `to` from the eye counts in its pixel, for one of n_l = width height
// light paths: p_c/(t^2 n_l), p_c = 1/(A cos^3) the density of the pixel's directions per solid angle, A = 4 |right||up|/n_l
// the pixel's area on the picture plane at distance 1. With cos = z/t that is t/(4 |right||up| z^3).
float eye_importance(Camera camera, vec3 to) {
    float distance = length3(to);
    float z = dot3(to, camera.forward);
    float right2 = dot3(camera.right, camera.right);
    float up2 = dot3(camera.up, camera.up);
    return distance / (4.0 * sqrt(right2 * up2) * (z * z * z));
}

// Where a pinhole sees the point `to` from it: (x, y) in pixels, from the picture's lower left corner.
vec2 picture_point(Camera camera, vec3 to) {
    float z = dot3(to, camera.forward);
    // dx = 2 x/W - 1 and dy = 2 y/H - 1
    float dx = dot3(to, camera.right) / (z * dot3(camera.right, camera.right));
    float dy = dot3(to, camera.up) / (z * dot3(camera.up, camera.up));
    return vec2((dx + 1.0) * 0.5 * float(camera.width), (dy + 1.0) * 0.5 * float(camera.height));
}

// The eye from the point `to` from it, which it sees at the point `at` of the picture.
EyeSample eye_at(Camera camera, vec3 to, vec2 at) {
    float distance = length3(to);
    bool inside = at.x >= 0.0 && at.x < float(camera.width) && at.y >= 0.0 && at.y < float(camera.height);
    bool seen = dot3(to, camera.forward) > 0.0 && inside;
    EyeSample eye;
    eye.wi = -to / (distance > 0.0 ? distance : 1.0);
    eye.distance = distance;
    eye.seen = seen;
    eye.column = seen ? uint(at.x) : 0u;
    eye.row = seen ? camera.height - 1u - uint(at.y) : 0u;
    eye.importance = eye_importance(camera, to);
    return eye;
}

// The eye of a pinhole from the point p.
EyeSample eye_sample(Camera camera, vec3 p) {
    vec3 to = p - camera.eye;
    return eye_at(camera, to, picture_point(camera, to));
}
