// Light that an eye path finds by hitting an emitter.
// Twin of the function of its name in src/reference/integrator/bidirectional/eye_path.rs.
// uses: constants/none, math/vec, path/vertex, integrator/bidirectional/partial, integrator/bidirectional/to_light, <light>, <pick>

// Radiance * weight. The density is taken from the last real vertex, `origin`, of pick_normal n, `distance` away; no
// connection could have found the light that the camera sees.
vec3 emission_seen(Subpath path, Partial partial, vec3 n, Vertex v, vec3 origin, float distance) {
    vec3 seen = vec3(0.0);
    uint light = shapes[v.shape].light;
    if (light != NONE) {
        float cosine = abs(dot3(path.ray.d, v.ng));
        float p_n = pick_probability(light, origin, n) * light_pdf(light, origin, v.prim, cosine, distance);
        float emission = emission_density(light, origin, v.prim, path.ray.d, v.p, cosine);
        seen = lights[light].radiance * (path.bounce == 0u ? 1.0 : hit_weight(partial, p_n, emission));
    }
    return seen;
}
