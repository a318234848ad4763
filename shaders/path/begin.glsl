// The start of a path: a camera ray through a point of the pixel.
// uses: shape/ray, camera/pinhole, sampler/dimensions, sampler/unit_float, <sampler>

void begin_path(inout PathState s, uint column, uint row) {
    uint sample_index = job.sample_begin + s.index;
    uvec4 u = sampler_block(row * camera.width + column, sample_index, camera_block(), camera.seed);
    s.o = camera.eye;
    s.d = camera_direction(camera, column, row, unit_float(u.x), unit_float(u.y));
    s.shape = NONE;
    s.prim = NONE;
    s.start = START_ELSEWHERE;
    s.t_self = 0.0;
    s.medium = job.eye_medium;
    s.throughput = vec3(1.0);
    s.eta_scale = 1.0;
    s.pdf = 0.0;
    s.delta = 1u;
    s.bounce = 0u;
    s.alive = 1u;
    s.index += 1u;
}
