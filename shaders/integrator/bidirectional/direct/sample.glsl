// A vertex of the eye path connected to a point of a light.
// Twin of src/reference/integrator/bidirectional/to_light.rs.
// uses: sampler/dimensions, integrator/path/direct/shadow, integrator/bidirectional/to_light, <sampler>, <pick>

ShadowRay join_light(Subpath path, Vertex v, Partial partial, uint pixel_index, uint sample_index) {
    weighed_at = partial;
    uvec4 u = sampler_block(pixel_index, sample_index, light_block(path.bounce), camera.seed);
    return shadow_to_light(path, v, pick(path, v, u));
}
