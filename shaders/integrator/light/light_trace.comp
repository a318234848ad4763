// Light tracing: light → path loop → splats on the pixels from which the eye sees the path's vertices.
//
// A thread follows the light paths that bear the number of one pixel, one a sample index. A turn of the loop is that of
// integrator/path/path_trace.comp: the connection that the last vertex left pending, then the extension ray. Light that
// arrives at the eye goes into the thread's own slots of `splats`, in the order of sample and vertex; the host adds it
// to the film. A thread whose slots are full, or whose budget is spent, continues in the next dispatch.
//
// Twin: src/reference/integrator/light/.
// uses: constants/workgroup, math/steps, path/trace, <light_shade>
layout(local_size_x = WORKGROUP) in;

bool unfinished(LightState s, Subpath path, ShadowRay shadow) {
    return path.alive != 0u || shadow.pending != 0u || s.index < job.sample_end;
}

void trace_light(uint thread) {
    uint threads = job.tile_width * job.tile_height;
    uint column = job.tile_x + thread % job.tile_width;
    uint row = job.tile_y + thread / job.tile_width;
    uint pixel_index = row * camera.width + column;
    LightState s = light_paths[thread];
    Subpath path = s.path;
    ShadowRay shadow = s.shadow;
    LightLane lane = LightLane(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    while (unfinished(s, path, shadow) && loop_steps < job.budget && lane.splats < SPLATS) {
        loop_steps += 1u;
        // The connection of a path that has ended comes first: the next path begins with one of its own.
        if (path.alive == 0u && shadow.pending == 0u) {
            begin(s, path, shadow, thread, pixel_index);
        }
        Traced traced = trace_rays(path, shadow);
        lane.rays += traced.rays;
        if (traced.visible) {
            splats[lane.splats * threads + thread] = Splat(shadow.contribution, s.pixel, s.splat_sample, 0u, 0u, 0u);
            lane.splats += 1u;
        }
        if (path.alive != 0u) {
            shade(s, path, shadow, traced, lane, thread, pixel_index);
        }
    }
    // A driver that ends loops early (Mesa 22) leaves their end conditions unmet: the picture would be wrong.
    bool more = unfinished(s, path, shadow);
    lane.loops = loop_failed || (more && loop_steps < job.budget && lane.splats < SPLATS) ? 1u : 0u;
    lane.unfinished = more ? 1u : 0u;
    s.path = path;
    s.shadow = shadow;
    light_paths[thread] = s;
    lanes[thread] = lane;
}

void main() {
    // Before any branch: see integrator/path/path_trace.comp.
    camera = camera_uniform;
    job = job_uniform;
    read_primitives();
    uint thread = gl_GlobalInvocationID.x;
    if (thread < job.tile_width * job.tile_height) {
        trace_light(thread);
    }
}
