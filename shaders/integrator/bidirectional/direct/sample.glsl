// A vertex of the eye path connected to a point of a light.
// Twin of src/reference/integrator/bidirectional/to_light.rs.
// uses: sampler/dimensions, integrator/path/direct/shadow, integrator/bidirectional/to_light, <sampler>, <pick>, <record>

ShadowRay join_light(inout EyeState s, Subpath path, Vertex v, Partial partial, uint pixel_index, uint sample_index) {
    weighed_at = partial;
    uvec4 u = sampler_block(pixel_index, sample_index, light_block(path.bounce), camera.seed);
    Candidate c = pick(path, v, u);
    record_light(s, c.contribution, c.light);
    return shadow_to_light(path, v, c);
}
