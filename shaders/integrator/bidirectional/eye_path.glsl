// A vertex of an eye path: its emission, its connections to a light and to the light path, and its next direction.
// uses: constants/bidirectional, constants/lobe, constants/material_kind, constants/none, constants/path, math/finite, math/steps, path/vertex, path/extend, camera/eye, integrator/bidirectional/bend, integrator/bidirectional/eye_rays, integrator/bidirectional/join, integrator/bidirectional/joint, integrator/bidirectional/partial, integrator/bidirectional/reservoir, <background>, <emission>, <direct>, <pick>, <depth>, <record>

void end_path(inout EyeState s, inout Subpath path) {
    path.alive = 0u;
    s.ended = 1u;
}

// Connects a vertex to a light, and to the kept vertices of its light path.
void join_all(inout EyeState s, Joint x, Subpath path, inout ShadowRay to_light, inout ShadowRay to_first, inout ShadowRay to_second,
              uint sample_index, uint thread, uint pixel_index) {
    to_light = join_light(s, path, x.v, x.partial, pixel_index, sample_index);
    uint seen = reservoirs[kept_index(1u, 0u, sample_index, thread)].seen;
    float share = kept_share(seen);
    uint place = 0u;
    while (place < seen && place < KEPT) {
        loop_steps += 1u;
        ShadowRay joined = join(x, kept_vertex(place, sample_index, thread), share);
        if (place == 0u) {
            to_first = joined;
        } else {
            to_second = joined;
        }
        place += 1u;
    }
}

// Continues in the next direction; ends the path where there is none.
void go_on(inout EyeState s, inout Subpath path, Joint x, inout LightLane lane, uint pixel_index) {
    s.pick_normal = pick_normal(x.v);
    Extension e = extend(path, x.v, pixel_index, s.done);
    lane.underflows += e.underflow ? 1u : 0u;
    // A broken throughput breaks the sample, which the film then drops and counts.
    s.radiance += e.broken ? path.throughput : vec3(0.0);
    record_lobe(s, path.throughput, e.lobe);
    lane.long_paths += e.alive && path.bounce == LONG_PATH ? 1u : 0u;
    Partial left = left_partial(path, x.v, x.wo, x.partial);
    s.vcm = left.vcm;
    s.vc = left.vc;
    if (!e.alive) {
        end_path(s, path);
    }
}

void shade(inout EyeState s, inout Subpath path, inout ShadowRay to_light, inout ShadowRay to_first,
           inout ShadowRay to_second, EyeTraced traced, inout LightLane lane, uint thread, uint pixel_index) {
    Partial along = Partial(s.vcm, s.vc);
    if (traced.hit.shape == NONE) {
        s.radiance += path.throughput * background_seen(path, along, s.pick_normal, traced.origin);
        record_escape(s, path.throughput);
        end_path(s, path);
    } else {
        Joint x;
        x.v = path_vertex(traced.ray, traced.hit, traced.distance, vec3(1.0));
        x.wo = -path.ray.d;
        x.carried = path.throughput;
        x.medium = path.ray.medium;
        x.count = path.bounce + 2u;
        record_hit(s, x);
        s.radiance += path.throughput * emission_seen(path, along, s.pick_normal, x.v, traced.origin, traced.distance);
        float cosine = abs(dot3(x.wo, x.v.ng));
        x.partial = arrive(along, traced.distance, cosine);
        if (path.bounce == 0u) {
            x.partial = from_eye(eye_importance(camera, x.v.p - traced.origin), cosine);
        }
        // A path starts with some light: a path with none has lost it to absorption.
        bool absorbed = is_black(path.throughput);
        lane.underflows += absorbed ? 1u : 0u;
        if (materials[x.v.material].kind == KIND_BLACK || depth_reached(path.bounce) || absorbed) {
            record_lobe(s, path.throughput, LOBE_NONE);
            end_path(s, path);
        } else {
            join_all(s, x, path, to_light, to_first, to_second, s.done, thread, pixel_index);
            go_on(s, path, x, lane, pixel_index);
        }
    }
}
