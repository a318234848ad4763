// The quantities that a rough reflection and a rough refraction through one micro-normal share.
// Twin of src/reference/bsdf/facet.rs.

// uses: math/vec, bsdf/interaction, <distribution>, <fresnel>, <choice>, <normals>

// A micro-normal between wo and wi.
struct Facet {
    // wo.m
    float c;
    // wi.m
    float ci;
    // Reflectance.
    vec3 f;
    // Probability that it reflects, given that it was drawn.
    float p_reflect;
    // Density with which it is drawn.
    float pm;
    // D(m) G1(wo) G1(wi)/wo.z
    float dg;
};

// The facet m between at.wo and wi.
Facet facet(Interaction at, vec3 wi, vec3 m) {
    float g = distribution_g1(at.material, at.wo) * distribution_g1(at.material, wi);
    Facet x;
    x.c = dot3(at.wo, m);
    x.ci = dot3(wi, m);
    x.f = fresnel(at, x.c);
    x.p_reflect = reflect_probability(at, x.c, carried_mean(at, x.f));
    x.pm = normals_pdf(at, m);
    x.dg = distribution_d(at.material, m) * g / at.wo.z;
    return x;
}
