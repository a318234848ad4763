// The start of a light path: a point of a light, and a direction about its normal.
// Twin of src/reference/integrator/light/begin.rs.
// uses: constants/ray, math/frame, shape/ray, bsdf/diffuse/lambert, sampler/dimensions, sampler/unit_float, <sampler>, <blocks>, <light_start>, <self_distance>

// A ray from that vertex.
Ray emitted_ray(LightStart start, vec3 d) {
    return Ray(start.point.p, FAR, d, start.shape, start.point.prim, START_OUTSIDE,
               self_distance(start.shape, start.point.p, start.point.n, d), start.medium);
}

// A path that starts along d.
Subpath leaving_path(LightStart start, vec3 d) {
    return Subpath(emitted_ray(start, d), vec3(1.0), 1.0, 0.0, 0u, 0u, start.emits ? 1u : 0u);
}

// The path that leaves it: L cos/p_e with p_e = P p_A cos/pi is pi L/(P p_A) for any direction. This is kept out of the
// throughput, so that roulette sees a path that starts with 1.
Subpath begin_light_path(LightStart start, uint pixel_index, uint sample_index) {
    uvec4 u = sampler_block(pixel_index, sample_index, path_block(light_block(0u)), camera.seed);
    vec3 d = to_world(frame_about(start.point.n), cosine_lobe(vec2(unit_float(u.x), unit_float(u.y))));
    return leaving_path(start, d);
}
