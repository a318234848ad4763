// Path tracing: pixel → camera ray → path loop → film. Read this first.
//
// A thread owns a pixel and follows its samples one after the other. A turn of the loop is a bounce: begin a path if
// none is alive, trace the shadow ray that the last vertex left pending and then the extension ray (through one call of
// nearest(), the heaviest function), add a sample that has ended to the film, shade the next vertex. A path that ends
// leaves its shadow ray pending while the thread already carries its next camera ray.
//
// Between two bounces the thread may stop, its state stored in `paths`, and continue in the next dispatch: no driver's
// watchdog and no limit on loops (Mesa 22: 65,535 iterations a subgroup and dispatch) can affect the picture.
//
// Twin: src/reference/integrator/path/, which makes the same decisions in the same order, one sample at a time.
// uses: constants/workgroup, math/steps, film/film_pixel, <moments>, <begin>, path/trace, integrator/path/shade, <record>
layout(local_size_x = WORKGROUP) in;

// For a pixel with `samples` complete samples.
bool unfinished(PathState s, Subpath path, uint samples) {
    return path.alive != 0u || s.ended != 0u || samples < job.sample_end;
}

void trace_pixel(uint lane) {
    uint column = job.tile_x + lane % job.tile_width;
    uint row = job.tile_y + lane / job.tile_width;
    PathState s = paths[lane];
    Subpath path = s.path;
    ShadowRay shadow = s.shadow;
    FilmPixel pixel = film[lane];
    while (unfinished(s, path, pixel.samples) && loop_steps < job.budget) {
        loop_steps += 1u;
        uint begun = pixel.samples + s.ended;
        if (path.alive == 0u && begun < job.sample_end) {
            path = begin_path(column, row, job.sample_begin + begun);
        }
        Traced traced = trace_rays(path, shadow);
        pixel.rays += traced.rays;
        if (traced.connected) {
            s.radiance += traced.visible ? shadow.contribution : vec3(0.0);
            record_connection(s, shadow, traced.visible);
        }
        if (s.ended != 0u) {
            record_sample(s, lane, pixel.samples);
            film_sample(pixel, s.radiance);
            moments_sample(lane, s.radiance, pixel.samples);
            s.radiance = vec3(0.0);
            s.ended = 0u;
        }
        if (path.alive != 0u) {
            shade(s, path, shadow, traced, pixel, row * camera.width + column, job.sample_begin + pixel.samples);
        }
    }
    // A driver that ends loops early (Mesa 22) leaves their end conditions unmet: the picture would be wrong.
    if (loop_failed || (unfinished(s, path, pixel.samples) && loop_steps < job.budget)) {
        pixel.loops += 1u;
    }
    s.path = path;
    s.shadow = shadow;
    paths[lane] = s;
    film[lane] = pixel;
}

void main() {
    // Data that threads read at fixed places are read here, before any branch: where lanes may be masked, lavapipe of Mesa 22.3
    // reads a uniform lane by lane, twenty instructions a float instead of one (emit_load_ubo, lp_bld_nir_soa.c).
    camera = camera_uniform;
    job = job_uniform;
    read_primitives();
    uint lane = gl_GlobalInvocationID.x;
    if (lane < job.tile_width * job.tile_height) {
        trace_pixel(lane);
    }
}
