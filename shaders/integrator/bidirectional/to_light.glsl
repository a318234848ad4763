// A vertex of the eye path connected to a light. Fills the slot <weigh>.
// Twin of src/reference/integrator/bidirectional/to_light.rs.
// uses: math/vec, path/vertex, light/sample, integrator/bidirectional/partial, integrator/bidirectional/bend, <aim>, <light_choice>, <emission_pdf>

// The quantities of the weights at the vertex that is connected: the slot has no argument for them.
Partial weighed_at;

// Density per area and solid angle of the start of a light path at q, a point of `prim` that p sees along wi, over the cosine
// there: P p_A p/cos.
float emission_density(uint light, vec3 p, uint prim, vec3 wi, vec3 q, float cosine) {
    return light_pmf(light) * emission_pdf(light, p, prim, wi) * aimed_density(q, -wi, cosine);
}

float weigh(Subpath path, Vertex v, uint light, LightSample l, float p, float bsdf_pdf) {
    Junction x = Junction(abs(dot3(l.wi, v.ng)), bsdf_pdf, reverse_pdf(v, l.wi, -path.ray.d));
    return light_weight(weighed_at, x, p, emission_density(light, v.p, l.prim, l.wi, v.p + l.wi * l.distance, l.cosine));
}
