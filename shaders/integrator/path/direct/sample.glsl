// Explicit connection of a vertex to a point on a light. Comes before roulette, which scales only the extension
// (model.md, "Roulette").
// uses: constants/ray, math/finite, path/vertex, path/spawn, sampler/dimensions, integrator/path/pick/candidate, <sampler>, <pick>, <crossing>, <record>

ShadowRay connect(inout PathState s, Subpath path, Vertex v, uint pixel_index, uint sample_index) {
    uvec4 u = sampler_block(pixel_index, sample_index, light_block(path.bounce), camera.seed);
    Candidate c = pick(path, v, u);
    record_light(s, c.contribution, c.light);
    ShadowRay shadow;
    shadow.pending = 0u;
    shadow.contribution = c.contribution;
    if (!is_black(c.contribution)) {
        shadow.ray = spawn_ray(v, c.point.wi, c.through, path.ray.medium);
        shadow.ray.t_max = c.point.distance < 0.0 ? FAR : c.point.distance;
        shadow.target_shape = lights[c.light].shape;
        shadow.target_prim = c.point.prim;
        shadow.pending = 1u;
    }
    return shadow;
}
