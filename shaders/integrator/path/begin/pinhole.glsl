// The start of a path: a camera ray through a point of the pixel. Fills the slot <begin>.
// uses: constants/none, constants/ray, shape/ray, camera/pinhole, sampler/dimensions, sampler/unit_float, <sampler>

Subpath begin_path(uint column, uint row, uint sample_index) {
    uvec4 u = sampler_block(row * camera.width + column, sample_index, camera_block(), camera.seed);
    vec3 d = camera_direction(camera, column, row, unit_float(u.x), unit_float(u.y));
    Ray ray = Ray(camera.eye, FAR, d, NONE, NONE, START_ELSEWHERE, 0.0, job.eye_medium);
    return Subpath(ray, vec3(1.0), 1.0, 0.0, 1u, 0u, 1u);
}
