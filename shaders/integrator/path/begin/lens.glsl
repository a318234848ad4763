// The start of a path: a camera ray from a point of the lens, through a point of the pixel. Fills the slot <begin>.
// uses: constants/none, constants/ray, shape/ray, camera/lens, camera/pinhole, sampler/dimensions, sampler/unit_float, <sampler>

Subpath begin_path(uint column, uint row, uint sample_index) {
    uvec4 u = sampler_block(row * camera.width + column, sample_index, camera_block(), camera.seed);
    vec2 q = disc_point(vec2(unit_float(u.z), unit_float(u.w)));
    vec2 at = lens_pixel(lens[0], q, vec2(unit_float(u.x), unit_float(u.y)));
    vec3 d = camera_direction(camera, column, row, at.x, at.y);
    Ray ray = Ray(lens_point(camera, lens[0], q), FAR, d, NONE, NONE, START_ELSEWHERE, 0.0, job.eye_medium);
    return Subpath(ray, vec3(1.0), 1.0, 0.0, 1u, 0u, 1u);
}
