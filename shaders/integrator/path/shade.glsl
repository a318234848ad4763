// A vertex of the path: its emission, its connection to a light, and its next direction.
// uses: constants/lobe, constants/material_kind, constants/none, constants/path, math/finite, path/vertex, path/trace, path/extend, sampler/dimensions, sampler/unit_float, <sampler>, <background>, <emission>, <direct>, <pick>, <depth>, <record>

void end_path(inout PathState s, inout Subpath path) {
    path.alive = 0u;
    s.ended = 1u;
}

// Continues in the next direction; ends the path where there is none.
void go_on(inout PathState s, inout Subpath path, Vertex v, inout FilmPixel pixel, uint pixel_index,
           uint sample_index) {
    s.pick_normal = pick_normal(v);
    Extension e = extend(path, v, pixel_index, sample_index);
    pixel.underflows += e.underflow ? 1u : 0u;
    // A broken throughput breaks the sample, which the film then drops and counts.
    s.radiance += e.broken ? path.throughput : vec3(0.0);
    pixel.long_paths += e.alive && path.bounce == LONG_PATH ? 1u : 0u;
    if (!e.alive) {
        end_path(s, path);
    }
    record_vertex(s, path, v, e.lobe);
}

void shade(inout PathState s, inout Subpath path, inout ShadowRay shadow, Traced traced, inout FilmPixel pixel,
           uint pixel_index, uint sample_index) {
    shadow.pending = 0u;
    if (traced.hit.shape == NONE) {
        s.radiance += path.throughput * background_seen(path, s.pick_normal, traced.origin);
        record_escape(s, path);
        end_path(s, path);
    } else {
        Vertex v = path_vertex(traced.ray, traced.hit, traced.distance, path.throughput);
        record_hit(s, path, v);
        s.radiance += path.throughput * emission_seen(path, s.pick_normal, v, traced.origin, traced.distance);
        // A path starts with some light: a path with none has lost it to absorption.
        bool absorbed = is_black(path.throughput);
        pixel.underflows += absorbed ? 1u : 0u;
        if (materials[v.material].kind == KIND_BLACK || depth_reached(path.bounce) || absorbed) {
            record_vertex(s, path, v, LOBE_NONE);
            end_path(s, path);
        } else {
            shadow = connect(s, path, v, pixel_index, sample_index);
            go_on(s, path, v, pixel, pixel_index, sample_index);
        }
    }
}
