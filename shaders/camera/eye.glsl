// The eye as a point sees it.
// Twin of src/reference/camera/eye.rs.

// uses: math/vec

// The way to the eye, and the pixel that looks back.
struct EyeSample {
    // Towards the eye, of unit length.
    vec3 wi;
    float distance;
    // The eye sees the point within the picture.
    bool seen;
    // Row 0 is at the top.
    uint column;
    uint row;
    // What radiance times cosine at the point adds to the pixel, for one of n_l = width height light paths:
    // p_c/(t^2 n_l), p_c = 1/(A cos^3) the density of the pixel's directions per solid angle, A = 4 |right||up|/n_l the
    // pixel's area on the picture plane at distance 1. With cos = z/t that is t/(4 |right||up| z^3).
    float importance;
};

// The eye from the point p.
EyeSample eye_sample(Camera camera, vec3 p) {
    vec3 to = p - camera.eye;
    float distance = length3(to);
    float z = dot3(to, camera.forward);
    float right2 = dot3(camera.right, camera.right);
    float up2 = dot3(camera.up, camera.up);
    // dx = 2 x/W - 1 and dy = 2 y/H - 1 of the point (x, y) in pixels, from the lower left corner
    float dx = dot3(to, camera.right) / (z * right2);
    float dy = dot3(to, camera.up) / (z * up2);
    float x = (dx + 1.0) * 0.5 * float(camera.width);
    float y = (dy + 1.0) * 0.5 * float(camera.height);
    bool seen = z > 0.0 && x >= 0.0 && x < float(camera.width) && y >= 0.0 && y < float(camera.height);
    EyeSample eye;
    eye.wi = -to / (distance > 0.0 ? distance : 1.0);
    eye.distance = distance;
    eye.seen = seen;
    eye.column = seen ? uint(x) : 0u;
    eye.row = seen ? camera.height - 1u - uint(y) : 0u;
    eye.importance = distance / (4.0 * sqrt(right2 * up2) * (z * z * z));
    return eye;
}
