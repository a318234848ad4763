// Visible normals of Beckmann.
// Twin of src/reference/bsdf/normals/visible/beckmann.rs.

// uses: math/vec, math/elementary/erfc_inverse, bsdf/interaction, bsdf/distribution/beckmann
// uses: bsdf/normals/visible/incidence, bsdf/normals/visible/slope

// The distribution of facets seen along the plane of incidence.
struct BeckmannView {
    // |(alpha wo.x, alpha wo.y, wo.z)|
    float len;
    SlopeLaw law;
};

// Slopes in units of alpha: wo.m = length (p + q t) mz, (p, q) = (wo.z, alpha sin theta)/length, and a Gaussian of them.
BeckmannView beckmann_view(vec3 wo, float sine, float alpha) {
    float up = abs(wo.z);
    float along = alpha * sine;
    float len = sqrt(up * up + along * along);
    float p = up / len;
    float q = along / len;
    // r = q/sqrt(pi)
    float r = q * 0.5641896;
    return BeckmannView(len, slope_law(p, r, 0.0, up / along));
}

// A visible micro-normal: the slope along the plane of incidence Gaussian times visibility, the one across it Gaussian
// (Heitz & d'Eon 2014; Jakob 2014).
vec3 visible_beckmann_sample(Interaction at, vec2 u) {
    float alpha = at.material.width;
    Incidence plane = incidence(at.wo);
    BeckmannView view = beckmann_view(at.wo, plane.sine, alpha);
    float along = alpha * slope_sample(view.law, u.x);
    float across = alpha * erfc_inverse(2.0 * above_zero(u.y));
    return normalize3(incidence_to_frame(plane, vec3(along, across, 1.0)));
}

// D_wo(m) = G1(wo) max(0, wo.m) D(m)/wo.z with Smith's own G1 = 2 p/G(-p/q), not the rational one.
float visible_beckmann_pdf(Interaction at, vec3 m) {
    float alpha = at.material.width;
    Incidence plane = incidence(at.wo);
    BeckmannView view = beckmann_view(at.wo, plane.sine, alpha);
    SlopeShare whole = slope_share(view.law, -view.law.limit);
    float c = max2(dot3(at.wo, m), 0.0);
    return 2.0 * c * beckmann_d(m, alpha) / (view.len * whole.share);
}
