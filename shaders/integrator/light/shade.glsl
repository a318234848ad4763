// A vertex of a light path: its connection to the eye, and where the path goes on.
// uses: constants/material_kind, constants/none, constants/path, math/finite, path/vertex, path/trace, path/extend, integrator/light/splat, <depth>

void shade(inout LightState s, inout Subpath path, inout ShadowRay shadow, Traced traced, inout LightLane lane,
           uint pixel_index) {
    bool alive = false;
    if (traced.hit.shape != NONE) {
        Vertex v = path_vertex(traced.ray, traced.hit, traced.distance, path.throughput);
        // A path sets out with some light: what has none has lost it to absorption.
        bool absorbed = is_black(path.throughput);
        lane.underflows += absorbed ? 1u : 0u;
        if (!(materials[v.material].kind == KIND_BLACK || depth_reached(path.bounce) || absorbed)) {
            shadow = splat_vertex(s, path, v);
            Extension e = extend(path, v, pixel_index, s.index - 1u);
            lane.underflows += e.underflow ? 1u : 0u;
            lane.long_paths += e.alive && path.bounce == LONG_PATH ? 1u : 0u;
            bool nan = e.broken && has_nan(path.throughput);
            lane.nan += nan ? 1u : 0u;
            lane.infinite += e.broken && !nan ? 1u : 0u;
            alive = e.alive;
        }
    }
    path.alive = alive ? 1u : 0u;
}
