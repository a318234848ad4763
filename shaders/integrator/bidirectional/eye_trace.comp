// Bidirectional path tracing, the eye's side: camera ray → path loop, joined to lights and to the kept vertices of the light
// path of the same sample → one radiance a sample.
//
// A turn of the loop is that of integrator/path/path_trace.comp. integrator/light/light_trace.comp has already followed
// the light paths of the same samples, and has left their vertices in `light_vertices`.
//
// Twin: src/reference/integrator/bidirectional/eye_path.rs.
// uses: constants/workgroup, math/steps, <begin>, integrator/bidirectional/eye_rays, integrator/bidirectional/eye_path, <record>
layout(local_size_x = WORKGROUP) in;

bool unfinished(EyeState s, Subpath path) {
    return path.alive != 0u || s.ended != 0u || s.done < job.sample_end;
}

void trace_eye(uint thread, uint column, uint row) {
    uint threads = job.tile_width * job.tile_height;
    EyeState s = eye_paths[thread];
    Subpath path = s.path;
    ShadowRay to_light = s.to_light;
    ShadowRay to_first = s.to_first;
    ShadowRay to_second = s.to_second;
    LightLane lane = LightLane(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    while (unfinished(s, path) && loop_steps < job.budget) {
        loop_steps += 1u;
        uint begun = s.done + s.ended;
        if (path.alive == 0u && begun < job.sample_end) {
            path = begin_path(column, row, begun);
        }
        EyeTraced traced = trace_eye_rays(s, path, to_light, to_first, to_second);
        lane.rays += traced.rays;
        if (s.ended != 0u) {
            radiances[(s.done - job.sample_begin) * threads + thread] = Radiance(s.radiance, take_signature(s));
            s.radiance = vec3(0.0);
            s.ended = 0u;
            s.done += 1u;
        }
        if (path.alive != 0u) {
            shade(s, path, to_light, to_first, to_second, traced, lane, thread, row * camera.width + column);
        }
    }
    // A driver that ends loops early (Mesa 22) leaves their end conditions unmet: the picture would be wrong.
    bool more = unfinished(s, path);
    lane.loops = loop_failed || (more && loop_steps < job.budget) ? 1u : 0u;
    lane.unfinished = more ? 1u : 0u;
    s.path = path;
    s.to_light = to_light;
    s.to_first = to_first;
    s.to_second = to_second;
    eye_paths[thread] = s;
    lanes[thread] = lane;
}

// Whether a pixel is rendered.
bool is_rendered(uint column, uint row) {
    uint x = column - job.film_x;
    uint y = row - job.film_y;
    return x < job.film_width && y < job.film_height;
}

void main() {
    // Before any branch: see integrator/path/path_trace.comp.
    camera = camera_uniform;
    job = job_uniform;
    read_primitives();
    uint thread = gl_GlobalInvocationID.x;
    uint column = job.tile_x + thread % job.tile_width;
    uint row = job.tile_y + thread / job.tile_width;
    if (thread < job.tile_width * job.tile_height) {
        if (is_rendered(column, row)) {
            trace_eye(thread, column, row);
        } else {
            lanes[thread] = LightLane(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        }
    }
}
