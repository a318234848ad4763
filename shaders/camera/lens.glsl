// A thin lens: rays start at points of its disc, and those through one point of the picture meet in the focal plane.
// Twin of src/reference/camera/lens.rs; struct Lens comes with the layout of buffers.

// uses: math/elementary/sincos, math/vec, camera/eye

// A point of the unit disc, uniform by area. Shirley & Chiu, A Low Distortion Map Between Disk and Square, JGT 2(3), 1997: a
// square of half the side s about the middle becomes the circle of radius s.
vec2 disc_point(vec2 u) {
    float a = 2.0 * u.x - 1.0;
    float b = 2.0 * u.y - 1.0;
    bool wide = abs(a) > abs(b);
    float s = wide ? a : b;
    // The angle from the axis of s, pi/4 ratio, is an eighth of a turn at most.
    float ratio = (wide ? b : a) / (s != 0.0 ? s : 1.0);
    vec2 phi = sincos_2pi(abs(ratio) * 0.125);
    float along = s * phi.y;
    float across = s * (ratio < 0.0 ? -phi.x : phi.x);
    return wide ? vec2(along, across) : vec2(across, along);
}

// The point q of the lens in space.
vec3 lens_point(Camera camera, Lens lens, vec2 q) {
    return camera.eye + (lens.right * q.x + lens.up * q.y);
}

// The point of the pixel through which a pinhole's ray has the direction of the ray from the lens's point q through the
// point `at`.
vec2 lens_pixel(Lens lens, vec2 q, vec2 at) {
    return at - q * lens.blur;
}

// The lens's point q from the point p.
EyeSample lens_sample(Camera camera, Lens lens, vec2 q, vec3 p) {
    vec3 to = p - lens_point(camera, lens, q);
    return eye_at(camera, to, picture_point(camera, to) + q * lens.blur);
}
