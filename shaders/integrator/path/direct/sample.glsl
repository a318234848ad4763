// Explicit connection of a vertex to a point on a light. Comes before roulette, which scales only the extension
// (model.md, "Roulette").
// uses: path/vertex, sampler/dimensions, integrator/path/direct/shadow, <sampler>, <pick>, <record>

ShadowRay connect(inout PathState s, Subpath path, Vertex v, uint pixel_index, uint sample_index) {
    uvec4 u = sampler_block(pixel_index, sample_index, light_block(path.bounce), camera.seed);
    Candidate c = pick(path, v, u);
    record_light(s, c.contribution, c.light);
    return shadow_to_light(path, v, c);
}
