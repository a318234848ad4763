// Explicit connection of a vertex to a point on a light. Comes before roulette, which scales only the extension
// (model.md, "Roulette").
// uses: constants/ray, math/finite, path/vertex, path/spawn, sampler/dimensions, sampler/unit_float, <sampler>, <light_choice>, <light>, <bsdf>, <connect>, <crossing>, <cover>, <record>

ShadowRay connect(inout PathState s, Subpath path, Vertex v, uint pixel_index) {
    uvec4 u = sampler_block(pixel_index, job.sample_begin + s.index - 1u, light_block(path.bounce), camera.seed);
    uint light = light_choice(u.x >> 8u);
    record_light(s, path, light);
    LightSample l = light_sample(light, v.p, u.y >> 8u, vec2(unit_float(u.z), unit_float(u.w)));
    float p = light_pmf(light) * l.pdf;
    vec3 wi = to_local(v.frame, l.wi);
    ShadowRay shadow;
    shadow.pending = 0u;
    // A broken density breaks the contribution, which the film then drops and counts.
    bool covered = is_covered_at(lights[light].shape, l.prim, v.p + l.wi * l.distance);
    bool sampled = (p > 0.0 || !is_finite(p)) && !covered;
    if (sampled && same_sides(v, l.wi, wi)) {
        BsdfValue f = bsdf_eval(v.interaction, wi);
        float weight = connection_weight(p, f.pdf);
        shadow.contribution = path.throughput * f.value * lights[light].radiance * (weight / p);
        if (!is_black(shadow.contribution)) {
            shadow.ray = spawn_ray(v, l.wi, leads_through(wi), path.ray.medium);
            shadow.ray.t_max = l.distance < 0.0 ? FAR : l.distance;
            shadow.target_shape = lights[light].shape;
            shadow.target_prim = l.prim;
            shadow.pending = 1u;
        }
    }
    return shadow;
}
