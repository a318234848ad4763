// The rays of one turn: the connections that the last vertex left pending, then the extension ray.
// uses: constants/none, math/steps, shape/ray, <nearest>, <medium>, <null_interface>, <record>

// The end of the extension ray, its distance from the last vertex, and that vertex.
struct EyeTraced {
    Hit hit;
    Ray ray;
    float distance;
    vec3 origin;
    // The number of rays traced.
    uint rays;
};

const uint PHASE_LIGHT = 0u;
const uint PHASE_FIRST = 1u;
const uint PHASE_SECOND = 2u;
const uint PHASE_EXTEND = 3u;
const uint PHASE_DONE = 4u;

// The first phase from `phase` on that has a ray.
uint next_phase(uint phase, uint light, uint first, uint second, uint alive) {
    uint next = alive != 0u ? PHASE_EXTEND : PHASE_DONE;
    next = phase <= PHASE_SECOND && second != 0u ? PHASE_SECOND : next;
    next = phase <= PHASE_FIRST && first != 0u ? PHASE_FIRST : next;
    next = phase <= PHASE_LIGHT && light != 0u ? PHASE_LIGHT : next;
    return phase > PHASE_EXTEND ? PHASE_DONE : next;
}

// One loop for all rays, so that nearest() has one call: compilers copy it into each call. Contributions are added to
// the sample in the order of the connections.
EyeTraced trace_eye_rays(inout EyeState s, inout Subpath path, inout ShadowRay to_light, inout ShadowRay to_first,
                         inout ShadowRay to_second) {
    EyeTraced traced;
    traced.origin = path.ray.o;
    traced.distance = 0.0;
    traced.rays = 0u;
    uint phase = next_phase(PHASE_LIGHT, to_light.pending, to_first.pending, to_second.pending, path.alive);
    ShadowRay shadow = to_light;
    if (phase == PHASE_FIRST) {
        shadow = to_first;
    }
    if (phase == PHASE_SECOND) {
        shadow = to_second;
    }
    while (phase != PHASE_DONE) {
        loop_steps += 1u;
        traced.rays += 1u;
        bool extends = phase == PHASE_EXTEND;
        Ray ray = path.ray;
        Target skip = Target(NONE, NONE);
        if (!extends) {
            ray = shadow.ray;
            skip = Target(shadow.target_shape, shadow.target_prim);
        }
        Hit hit = nearest(ray, skip, !extends && !SHADOW_RAYS_PASS);
        vec3 transmittance = stretch_transmittance(ray.medium, hit.t);
        if (is_null_interface(hit)) {
            Skipped skipped = skip_intersection(ray, hit);
            if (extends) {
                path.throughput *= transmittance * skipped.factor;
                path.ray = skipped.ray;
                traced.distance += hit.t;
            } else {
                shadow.contribution *= transmittance * skipped.factor;
                shadow.ray = skipped.ray;
            }
        } else {
            if (extends) {
                path.throughput *= transmittance;
                traced.hit = hit;
                traced.ray = ray;
                traced.distance += hit.t;
            } else {
                // A connection of two vertices arrives in the medium that its far end faces, or not at all.
                bool arrives = hit.shape == NONE && (phase == PHASE_LIGHT || ray.medium == shadow.medium);
                vec3 arrived = shadow.contribution * transmittance;
                record_arrival(s, arrived, arrives);
                s.radiance += arrives ? arrived : vec3(0.0);
            }
            phase = next_phase(phase + 1u, 0u, to_first.pending, to_second.pending, path.alive);
            if (phase == PHASE_FIRST) {
                shadow = to_first;
            }
            if (phase == PHASE_SECOND) {
                shadow = to_second;
            }
        }
    }
    to_light.pending = 0u;
    to_first.pending = 0u;
    to_second.pending = 0u;
    loop_failed = loop_failed || phase != PHASE_DONE;
    return traced;
}
