// The code that kinds with micro-normals share: how a sample begins, and their reflecting side.
// Twin of src/reference/bsdf/rough.rs.

// uses: constants/lobe, math/vec, bsdf/interaction, bsdf/sample, bsdf/facet, bsdf/reflection
// uses: <fresnel>, <choice>, <normals>, <diffuse>

// The first draws of a sample of a rough surface.
struct RoughDraw {
    // The diffuse lobe was chosen.
    bool diffuse;
    // A micro-normal, for either lobe; wo may be unable to see it.
    vec3 m;
    // wo.m
    float c;
};

// The choice between Kd and the rest, and a micro-normal (model.md, "Sampling a direction").
RoughDraw rough_draw(Interaction at, BsdfRandom random) {
    vec3 m = normals_sample(at, random.m);
    return RoughDraw(diffuse_chosen(at, random.lobe), m, dot3(at.wo, m));
}

// Whether the drawn micro-normal reflects, with probability R(c); else it refracts.
bool rough_reflects(Interaction at, RoughDraw draw, BsdfRandom random) {
    float f_mean = carried_mean(at, fresnel(at, draw.c));
    return random.reflect < reflect_probability(at, draw.c, f_mean);
}

// Value and density of wi on wo's side, whose micro-normal is m: Kd/pi and E_r.
BsdfValue rough_reflection_at(Interaction at, vec3 wi, vec3 m) {
    Facet x = facet(at, wi, m);
    return with_diffuse(at, wi, reflection_lobe(at, wi, x));
}

// The sample on wo's side: a diffuse direction, or wo mirrored about the drawn micro-normal.
BsdfSample rough_reflection_sample(Interaction at, RoughDraw draw, BsdfRandom random) {
    bool diffuse = draw.diffuse;
    vec3 wi = diffuse ? diffuse_direction(random.d) : reflect_about(at.wo, draw.m, draw.c);
    vec3 m = diffuse ? reflection_half_vector(at.wo, wi) : draw.m;
    bool valid = (diffuse || draw.c > 0.0) && wi.z > 0.0;
    uint lobe = diffuse ? LOBE_DIFFUSE : LOBE_REFLECTION;
    return sample_or_none(valid, wi, rough_reflection_at(at, wi, m), lobe);
}
