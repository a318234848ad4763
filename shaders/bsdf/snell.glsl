// Snell's law about a micro-normal, and total reflection.
// Twin of src/reference/bsdf/snell.rs.

// uses: bsdf/interaction

// r = 1 - eta^2 (1 - c^2) = (wi.m)^2 of the refracted direction, c = wo.m; not positive: total reflection.
// Fresnel, Schlick's cosine and refraction all use this one radicand, so that they agree next to the critical angle.
float snell_radicand(Interaction at, float c) {
    float p = at.eta * c;
    return at.one_minus_eta2 + p * p;
}

// Whether light that meets a micro-normal at cosine c is totally reflected.
bool total_reflection(Interaction at, float c) {
    return snell_radicand(at, c) <= 0.0;
}

// The share of light that an interface reflects: F, or at total reflection, where F = 1, the A(t) that absorption by
// `term` puts in the place of E_r.
vec3 reflected_share(Interaction at, float c, vec3 f) {
    return total_reflection(at, c) ? at.attenuation : f;
}
