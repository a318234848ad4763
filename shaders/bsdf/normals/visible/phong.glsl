// Nearly the visible normals of Phong.
// Twin of src/reference/bsdf/normals/visible/phong.rs, which has the formulas and the bound of the weight.

// uses: math/vec, math/elementary/exp, math/elementary/expm1, math/elementary/log1p, math/elementary/erfc_inverse
// uses: bsdf/interaction, bsdf/distribution/phong
// uses: bsdf/normals/visible/incidence, bsdf/normals/visible/slope

// kappa of the lean along the plane of incidence, k = alpha + 1.
float phong_along(float alpha) {
    return alpha + 1.5;
}

// kappa of the lean across it, k = alpha + 2.
float phong_across(float alpha) {
    return alpha + 2.5;
}

// x of the lean along the plane, of density cos theta cos^(n+1) psi h(psi) + sin theta cos^n psi sin psi in psi:
// p = cos theta sqrt(pi/(2 kappa)), r = sin theta/(n + 1), cos^(n+1) psi = e^(-(1 - gamma) x^2) with gamma = 1/(2 kappa).
// wo sees down to cos psi = sin theta, -ln sin theta = ln(1 + cot^2 theta)/2.
SlopeLaw phong_law(vec3 wo, float sine, float alpha) {
    float kappa = phong_along(alpha);
    float up = abs(wo.z);
    float p = up * sqrt(1.5707964 / kappa);
    float cot = up / sine;
    float limit = sqrt(0.5 * kappa * log1p(cot * cot));
    return slope_law(p, sine / (alpha + 1.0), 0.5 / kappa, limit);
}

// Sine and cosine of the lean at x.
vec2 phong_lean(float x, float kappa) {
    float y = x * x / kappa;
    float sine = sqrt(-expm1(-(y + y)));
    return vec2(x < 0.0 ? -sine : sine, exp(-y));
}

// h = sqrt(sinh y/y) of the lean whose tangent squared is t2: y = ln(1 + t2)/2, sinh y = t2/(2 sqrt(1 + t2)).
float phong_excess(float t2) {
    // beyond, a Phong lobe has no facets, and squares overflow
    float t = min2(t2, 1e30);
    float h = sqrt(t / (sqrt(1.0 + t) * log1p(t)));
    return t > 0.0 ? h : 1.0;
}

// A micro-normal with the density of visible_phong_pdf.
vec3 visible_phong_sample(Interaction at, vec2 u) {
    float alpha = at.material.alpha;
    Incidence plane = incidence(at.wo);
    float along = slope_sample(phong_law(at.wo, plane.sine, alpha), u.x);
    vec2 psi = phong_lean(along, phong_along(alpha));
    float across = erfc_inverse(2.0 * above_zero(u.y));
    vec2 eta = phong_lean(across, phong_across(alpha));
    vec3 m = vec3(eta.y * psi.x, eta.x, eta.y * psi.y);
    return normalize3(incidence_to_frame(plane, m));
}

// D(m) h(eta) (wo.z m.z h(psi) + sin theta m.x) 2 pi/(n + 2)/(sqrt(2 pi/kappa) G(-limit)), m.x along the plane of
// incidence.
float visible_phong_pdf(Interaction at, vec3 m) {
    float alpha = at.material.alpha;
    Incidence plane = incidence(at.wo);
    SlopeLaw law = phong_law(at.wo, plane.sine, alpha);
    SlopeShare whole = slope_share(law, -law.limit);
    vec3 v = incidence_from_frame(plane, m);
    float h_psi = phong_excess(v.x * v.x / (v.z * v.z));
    float h_eta = phong_excess(v.y * v.y / (v.x * v.x + v.z * v.z));
    float c = at.wo.z * v.z * h_psi + plane.sine * v.x;
    // 2 pi/sqrt(2 pi/kappa) = sqrt(2 pi kappa)
    float scale = sqrt(6.2831855 * phong_across(alpha)) / ((alpha + 2.0) * whole.share);
    float pdf = phong_d(m, alpha) * h_eta * c * scale;
    return dot3(at.wo, m) > 0.0 ? pdf : 0.0;
}
