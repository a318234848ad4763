// Radiance of the surroundings, found by a path that leaves the scene.
// uses: <outside>, <pick>, <connect>

vec3 background_seen(Subpath path, vec3 n, vec3 origin) {
    Outside outside = outside_seen(path.ray.d);
    float q = pick_probability(BACKGROUND_LIGHT, origin, n) * outside.pdf;
    return outside.radiance * hit_weight(path.delta != 0u, path.pdf, q);
}
