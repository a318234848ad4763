// The refracted direction. Equation numbers are those of Walter et al. 2007.
// Twin of src/reference/bsdf/refraction.rs.

// uses: math/vec, bsdf/interaction, bsdf/snell

// sqrt(r) = |wi.m| of the direction refracted at cosine c = wo.m; 0 at total reflection.
float refracted_cosine(Interaction at, float c) {
    return sqrt(max2(snell_radicand(at, c), 0.0));
}

// wi.m + eta c = eta c - sqrt(r), without cancellation: -(1 - eta^2)/(eta c + sqrt(r)).
float bend(Interaction at, float c) {
    return -at.one_minus_eta2 / (at.eta * c + refracted_cosine(at, c));
}

// wi = (eta c - sqrt(r))m - eta wo (eq. 40), normalized; c = wo.m and r > 0.
vec3 refract_about(Interaction at, vec3 m, float c) {
    return normalize3(m * bend(at, c) - at.wo * at.eta);
}

// The same about N' itself, whose cosine is wo.z: wi.z = -sqrt(r).
vec3 refract_about_normal(Interaction at) {
    float x = at.eta * at.wo.x;
    float y = at.eta * at.wo.y;
    return normalize3(vec3(-x, -y, -refracted_cosine(at, at.wo.z)));
}
