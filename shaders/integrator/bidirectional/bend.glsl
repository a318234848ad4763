// The scattering at a vertex where a path is joined, and its densities from either side.
// Twin of src/reference/integrator/bidirectional/bend.rs.
// uses: math/finite, math/vec, shape/ray, path/vertex, integrator/bidirectional/partial, <bsdf>, <correction>, <crossing>

// One end of a connection.
struct Bend {
    // Value * cosine.
    vec3 f;
    Junction junction;
    // The connection leads through the surface.
    bool through;
    // Light goes this way.
    bool some;
};

// Density per solid angle with which a path that comes from wi, with grey throughput, would leave v towards wo.
float reverse_pdf(Vertex v, vec3 wi, vec3 wo) {
    Seen seen = seen_from(v.interaction.material, v.ng, v.ns, wi);
    vec3 back = to_local(seen.frame, wo);
    float pdf = bsdf_eval(seen.interaction, back).pdf;
    return same_sides(seen.facing, wo, back) ? pdf : 0.0;
}

// The scattering at v of a path that came along wo, in the direction wi.
Bend bend(Vertex v, vec3 wo, vec3 wi) {
    vec3 local = to_local(v.frame, wi);
    BsdfValue value = bsdf_eval(v.interaction, local);
    vec3 f = corrected(v, wi, local, value.value);
    bool some = same_sides(v.facing, wi, local) && !is_black(f);
    return Bend(f, Junction(abs(dot3(wi, v.ng)), value.pdf, reverse_pdf(v, wi, wo)), leads_through(local), some);
}

// The quantities of the weights along the direction in which a path has just left v.
Partial left_partial(Subpath path, Vertex v, vec3 wo, Partial at) {
    vec3 wi = path.ray.d;
    float cosine = abs(dot3(wi, v.ng));
    Partial left = scatter(at, Junction(cosine, path.pdf, reverse_pdf(v, wi, wo)));
    if (path.delta != 0u) {
        left = scatter_delta(at, cosine);
    }
    return left;
}
