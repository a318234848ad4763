// The ray from a vertex to a point of a light that looks for occluders.
// Twin of src/reference/integrator/path/direct.rs.
// uses: constants/ray, math/finite, path/spawn, integrator/path/pick/candidate

// Pending unless the point contributes nothing.
ShadowRay shadow_to_light(Subpath path, Vertex v, Candidate c) {
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
