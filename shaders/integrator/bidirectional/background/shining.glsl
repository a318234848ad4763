// Radiance of the surroundings, which send out no light paths.
// Twin of the function of its name in src/reference/integrator/bidirectional/eye_path.rs.
// uses: integrator/bidirectional/partial, <outside>, <pick>

vec3 background_seen(Subpath path, Partial partial, vec3 n, vec3 origin) {
    Outside outside = outside_seen(path.ray.d);
    float p_n = pick_probability(BACKGROUND_LIGHT, origin, n) * outside.pdf;
    return outside.radiance * (path.bounce == 0u ? 1.0 : hit_weight(partial, p_n, 0.0));
}
