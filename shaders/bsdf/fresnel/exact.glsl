// Fresnel's equations for a dielectric and unpolarised light.
// Twin of src/reference/bsdf/fresnel/exact.rs.

// uses: math/vec, bsdf/interaction, bsdf/snell

// Walter et al. 2007, eq. 22, with g = sqrt(c^2 + d) = sqrt(r)/eta, d = (n_i/n_o)^2 - 1:
// F = A^2 (1 + B^2)/2, A = (g - c)/(g + c) = d/(g + c)^2, B = (c(g + c) - 1)/(c(g - c) + 1), g - c = d/(g + c).
vec3 fresnel_exact(Interaction at, float c) {
    float r = snell_radicand(at, c);
    float g = sqrt(max2(r, 0.0)) / at.eta;
    float sum = g + c;
    float a = at.d / (sum * sum);
    float b = (c * sum - 1.0) / (1.0 + c * at.d / sum);
    float f = min2(0.5 * a * a * (1.0 + b * b), 1.0);
    return vec3(r <= 0.0 ? 1.0 : f);
}
