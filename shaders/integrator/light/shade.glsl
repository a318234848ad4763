// A light path alone: its connections to the eye, and its next direction. Fills the slot <light_shade>.
// uses: constants/material_kind, constants/none, math/finite, path/vertex, path/trace, path/extend, integrator/light/begin, integrator/light/splat, <depth>

// Begins the next light path, with the light itself as the eye sees it.
void begin(inout LightState s, inout Subpath path, inout ShadowRay shadow, uint thread, uint pixel_index) {
    LightStart start = light_start(pixel_index, s.index);
    path = begin_light_path(start, pixel_index, s.index);
    s.power = start.radiance * 3.141592653589793;
    s.index += 1u;
    leave_pending(s, shadow, splat_light(start, pixel_index, s.index - 1u));
}

void shade(inout LightState s, inout Subpath path, inout ShadowRay shadow, Traced traced, inout LightLane lane, uint thread,
           uint pixel_index) {
    bool alive = false;
    if (traced.hit.shape != NONE) {
        Vertex v = path_vertex(traced.ray, traced.hit, traced.distance, path.throughput);
        // A path starts with some light: a path with none has lost it to absorption.
        bool absorbed = is_black(path.throughput);
        lane.underflows += absorbed ? 1u : 0u;
        if (!(materials[v.material].kind == KIND_BLACK || depth_reached(path.bounce) || absorbed)) {
            leave_pending(s, shadow, splat_vertex(s.power, path, v, pixel_index, s.index - 1u));
            Extension e = extend(path, v, pixel_index, s.index - 1u);
            count_extension(path, e, lane);
            alive = e.alive;
        }
    }
    path.alive = alive ? 1u : 0u;
}
