// A light path whose vertices are joined to the eye, and kept for eye paths. Fills the slot <light_shade>.
// uses: constants/bidirectional, constants/lobe, constants/material_kind, constants/none, constants/path, math/finite, path/vertex, path/trace, path/extend, camera/eye, sampler/dimensions, sampler/unit_float, integrator/light/begin, integrator/light/splat, integrator/bidirectional/bend, integrator/bidirectional/joint, integrator/bidirectional/partial, integrator/bidirectional/reservoir, <sampler>, <blocks>, <aim>, <first_partial>, <depth>, <lens>, <record>

// The eye path finds the light that the eye sees directly: no splat is pending.
void begin(inout LightState s, inout Subpath path, inout ShadowRay shadow, uint thread, uint pixel_index) {
    LightStart start = light_start(pixel_index, s.index);
    uvec4 u = sampler_block(pixel_index, s.index, path_block(light_block(0u)), camera.seed);
    vec3 d = aimed_direction(start.point.p, start.point.n, unit_float(u.z), vec2(unit_float(u.x), unit_float(u.y)));
    path = leaving_path(start, d);
    float cosine = dot3(d, start.point.n);
    // Half the cone of an aim may be behind the light.
    path.alive = cosine > 0.0 ? path.alive : 0u;
    // L cos/p_e, p_e = P p_A p: `radiance` is L/(P p_A), `density` p/cos.
    float density = aimed_density(start.point.p, d, cosine);
    s.power = start.radiance / density;
    s.emission = start.pdf * density;
    s.light = start.light;
    s.light_prim = start.point.prim;
    s.light_cosine = abs(cosine);
    reservoirs[kept_index(1u, 0u, s.index, thread)].seen = 0u;
    record_start(s.index, thread);
    s.index += 1u;
}

// Keeps a vertex, or does not.
void offer(Joint y, uint bounce, uint sample_index, uint thread, uint pixel_index) {
    if (has_density(y.v.interaction.material.kind, y.v.interaction.material.kd)) {
        uvec4 u = sampler_block(pixel_index, sample_index, path_block(roulette_block(bounce)), camera.seed);
        uint at = kept_index(1u, 0u, sample_index, thread);
        uint seen = reservoirs[at].seen;
        uint place = kept_place(seen, unit_float(u.w));
        if (place < KEPT) {
            keep_vertex(y, place, sample_index, thread);
        }
        reservoirs[at].seen = seen + 1u;
    }
}

// A vertex joined to the eye.
SplatRay weighed_splat(Joint y, uint pixel_index, uint sample_index) {
    EyeSample eye = eye_drawn(pixel_index, sample_index, light_block(y.count - 1u), y.v.p);
    Bend at = bend(y.v, y.wo, eye.wi);
    float w = splat_weight(y.partial, at.junction, eye.importance);
    vec3 contribution = y.carried * at.f * eye.importance * vec3(w);
    return splat_ray(eye, spawn_ray(y.v, eye.wi, at.through, y.medium), at.some ? contribution : vec3(0.0));
}

void shade(inout LightState s, inout Subpath path, inout ShadowRay shadow, Traced traced, inout LightLane lane, uint thread,
           uint pixel_index) {
    bool alive = false;
    uint sample_index = s.index - 1u;
    if (traced.hit.shape == NONE) {
        record_escape(sample_index, thread, path.throughput);
    } else {
        Joint y;
        y.v = path_vertex(traced.ray, traced.hit, traced.distance, vec3(1.0));
        y.wo = -path.ray.d;
        y.carried = s.power * path.throughput;
        y.medium = path.ray.medium;
        y.count = path.bounce + 2u;
        record_hit(sample_index, thread, y);
        Partial first = first_partial(s, y.v, y.wo, traced.distance);
        y.partial = arrive(Partial(s.vcm, s.vc), traced.distance, abs(dot3(y.wo, y.v.ng)));
        if (path.bounce == 0u) {
            y.partial = first;
        }
        // A path starts with some light: a path with none has lost it to absorption.
        bool absorbed = is_black(path.throughput);
        lane.underflows += absorbed ? 1u : 0u;
        if (materials[y.v.material].kind == KIND_BLACK || depth_reached(path.bounce) || absorbed) {
            record_lobe(sample_index, thread, path.throughput, LOBE_NONE);
        } else {
            offer(y, path.bounce, sample_index, thread, pixel_index);
            leave_pending(s, shadow, weighed_splat(y, pixel_index, sample_index));
            Extension e = extend(path, y.v, pixel_index, sample_index);
            count_extension(path, e, lane);
            record_lobe(sample_index, thread, path.throughput, e.lobe);
            Partial left = left_partial(path, y.v, y.wo, y.partial);
            s.vcm = left.vcm;
            s.vc = left.vc;
            alive = e.alive;
        }
    }
    path.alive = alive ? 1u : 0u;
}
