// The rays of one turn: the pending shadow ray, then the extension ray.
// uses: constants/none, math/steps, shape/ray, <nearest>, <medium>, <null_interface>

// The end of the extension ray, its distance from the last vertex, and that vertex; the outcome of the shadow ray.
struct Traced {
    Hit hit;
    Ray ray;
    float distance;
    vec3 origin;
    // A connection was pending.
    bool connected;
    // Nothing was in its way.
    bool visible;
    // The number of rays traced.
    uint rays;
};

const uint PHASE_SHADOW = 0u;
const uint PHASE_EXTEND = 1u;
const uint PHASE_DONE = 2u;

// One loop for both rays, so that nearest() has one call: compilers copy it into each call.
Traced trace_rays(inout Subpath path, inout ShadowRay shadow) {
    Traced traced;
    traced.origin = path.ray.o;
    traced.distance = 0.0;
    traced.connected = shadow.pending != 0u;
    traced.visible = false;
    traced.rays = 0u;
    uint phase = traced.connected ? PHASE_SHADOW : (path.alive != 0u ? PHASE_EXTEND : PHASE_DONE);
    while (phase != PHASE_DONE) {
        loop_steps += 1u;
        traced.rays += 1u;
        Ray ray = path.ray;
        Target skip = Target(NONE, NONE);
        if (phase == PHASE_SHADOW) {
            ray = shadow.ray;
            skip = Target(shadow.target_shape, shadow.target_prim);
        }
        Hit hit = nearest(ray, skip, phase == PHASE_SHADOW && !SHADOW_RAYS_PASS);
        vec3 transmittance = stretch_transmittance(ray.medium, hit.t);
        if (is_null_interface(hit)) {
            Skipped skipped = skip_intersection(ray, hit);
            if (phase == PHASE_SHADOW) {
                shadow.contribution *= transmittance * skipped.factor;
                shadow.ray = skipped.ray;
            } else {
                path.throughput *= transmittance * skipped.factor;
                path.ray = skipped.ray;
                traced.distance += hit.t;
            }
        } else if (phase == PHASE_SHADOW) {
            traced.visible = hit.shape == NONE;
            shadow.contribution *= transmittance;
            shadow.pending = 0u;
            phase = path.alive != 0u ? PHASE_EXTEND : PHASE_DONE;
        } else {
            path.throughput *= transmittance;
            traced.hit = hit;
            traced.ray = ray;
            traced.distance += hit.t;
            phase = PHASE_DONE;
        }
    }
    loop_failed = loop_failed || phase != PHASE_DONE;
    return traced;
}
