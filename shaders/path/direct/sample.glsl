// Explicit connection of a vertex to a point on a light. Comes before roulette, which scales only the extension
// (model.md, "Roulette").
// uses: math/finite, path/vertex, sampler/dimensions, sampler/unit_float, <sampler>, <self_distance>, <light_choice>, <light>, <bsdf>, <connect>, <crossing>, <medium>, <record>

void connect(inout PathState s, Vertex v, uint pixel_index) {
    uvec4 u = sampler_block(pixel_index, job.sample_begin + s.index - 1u, light_block(s.bounce), camera.seed);
    uint light = light_choice(u.x >> 8u);
    record_light(s, light);
    LightSample l = light_sample(light, v.p, u.y >> 8u, vec2(unit_float(u.z), unit_float(u.w)));
    float p = light_pmf(light) * l.pdf;
    vec3 wi = to_local(v.frame, l.wi);
    s.connecting = 0u;
    // A broken density breaks the contribution, which the film then drops and counts.
    bool sampled = p > 0.0 || !is_finite(p);
    if (sampled && same_sides(v, l.wi, wi)) {
        BsdfValue f = bsdf_eval(v.interaction, wi);
        float weight = connection_weight(p, f.pdf);
        s.contribution = s.throughput * f.value * lights[light].radiance * (weight / p);
        if (!is_black(s.contribution)) {
            bool through = leads_through(wi);
            bool goes_outside = v.outside != through;
            s.shadow_o = v.p;
            s.shadow_d = l.wi;
            s.shadow_shape = v.shape;
            s.shadow_prim = v.prim;
            s.shadow_start = goes_outside ? START_OUTSIDE : START_INSIDE;
            s.shadow_t_self = self_distance(v.shape, v.p, v.ng, l.wi);
            s.shadow_distance = l.distance < 0.0 ? FAR : l.distance;
            s.shadow_medium = medium_after(v, through, s.medium);
            s.target_shape = lights[light].shape;
            s.target_prim = l.prim;
            s.connecting = 1u;
        }
    }
}
