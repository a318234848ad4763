// Light that a path finds by hitting an emitter.
// uses: constants/none, math/vec, path/vertex, <light>, <pick>, <connect>

// Radiance · weight. The density is taken from the last real vertex, `origin`, of pick_normal n, `distance` away.
vec3 emission_seen(Subpath path, vec3 n, Vertex v, vec3 origin, float distance) {
    vec3 seen = vec3(0.0);
    uint light = shapes[v.shape].light;
    if (light != NONE) {
        float cosine = abs(dot3(path.ray.d, v.ng));
        float q = pick_probability(light, origin, n) * light_pdf(light, origin, v.prim, cosine, distance);
        seen = lights[light].radiance * hit_weight(path.delta != 0u, path.pdf, q);
    }
    return seen;
}
