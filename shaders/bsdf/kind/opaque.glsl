// Opaque: a rough reflection, and Kd.
// Twin of src/reference/bsdf/kind/opaque.rs.

// uses: math/vec, bsdf/interaction, bsdf/sample, bsdf/facet, bsdf/reflection, <normals>, <diffuse>

// Value and density of wi whose micro-normal is m.
BsdfValue opaque_at(Interaction at, vec3 wi, vec3 m) {
    Facet x = facet(at, wi, m);
    return with_diffuse(at, wi, reflection_lobe(at, wi, x));
}

BsdfSample opaque_sample(Interaction at, float u_lobe, float u_reflect, vec2 u_m, vec2 u_d) {
    bool diffuse = diffuse_chosen(at, u_lobe);
    vec3 drawn = normals_sample(at, u_m);
    float c = dot3(at.wo, drawn);
    vec3 wi = diffuse ? diffuse_direction(u_d) : reflect_about(at.wo, drawn, c);
    vec3 m = diffuse ? reflection_half_vector(at.wo, wi) : drawn;
    bool valid = (diffuse || c > 0.0) && wi.z > 0.0;
    uint lobe = diffuse ? LOBE_DIFFUSE : LOBE_REFLECTION;
    return sample_or_none(valid, wi, opaque_at(at, wi, m), lobe);
}

BsdfValue opaque_eval(Interaction at, vec3 wi) {
    return opaque_at(at, wi, reflection_half_vector(at.wo, wi));
}
