// Visible normals of GGX.
// Twin of src/reference/bsdf/normals/visible/ggx.rs.

// uses: math/vec, math/elementary/sincos, bsdf/interaction, bsdf/distribution/ggx

// A visible micro-normal (Dupuy & Benyoub, Sampling Visible GGX Normals with Spherical Caps, 2023).
// w = normalize(alpha wo.x, alpha wo.y, wo.z); a point of the cap z in (-w.z, 1] about N, and h = this point + w. In z
// = (1 - u2)(1 + w.z) - w.z both h.z and 1 +- z would cancel; computed separately they do not.
vec3 visible_ggx_sample(Interaction at, vec2 u) {
    float alpha = at.material.width;
    vec3 w = normalize3(vec3(alpha * at.wo.x, alpha * at.wo.y, at.wo.z));
    vec2 phi = sincos_2pi(u.x);
    float height = 1.0 + w.z;
    // h.z = z + w.z
    float h_z = (1.0 - u.y) * height;
    // 1 - z, and 1 + z = h.z + (1 - w.z), 1 - w.z = (w.x^2 + w.y^2)/(1 + w.z)
    float below_top = u.y * height;
    float above_bottom = h_z + (w.x * w.x + w.y * w.y) / height;
    float radius = sqrt(below_top * above_bottom);
    float h_x = radius * phi.y + w.x;
    float h_y = radius * phi.x + w.y;
    return normalize3(vec3(alpha * h_x, alpha * h_y, h_z));
}

// D_wo(m) = G1(wo) max(0, wo.m) D(m)/wo.z (Heitz 2018, eq. 3).
float visible_ggx_pdf(Interaction at, vec3 m) {
    float alpha = at.material.width;
    float c = max2(dot3(at.wo, m), 0.0);
    return ggx_g1(at.wo, alpha) * c * ggx_d(m, alpha) / at.wo.z;
}
