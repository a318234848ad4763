// The quantities of the weights at the first vertex that light reaches. Fills the slot <first_partial>.
// Twin of the function of its name in src/reference/integrator/bidirectional/light_path.rs.
// uses: math/vec, path/vertex, integrator/bidirectional/partial, <light>, <pick>

// v is `distance` away from the light's point, which it sees along wo.
Partial first_partial(LightState s, Vertex v, vec3 wo, float distance) {
    float expected = pick_probability(s.light, v.p, pick_normal(v));
    float p_n = expected * light_pdf(s.light, v.p, s.light_prim, s.light_cosine, distance);
    return from_light_point(p_n, s.emission, abs(dot3(wo, v.ng)));
}
