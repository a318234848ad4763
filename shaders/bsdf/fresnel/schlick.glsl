// Schlick's approximation.
// Twin of src/reference/bsdf/fresnel/schlick.rs.

// uses: math/vec, bsdf/interaction, bsdf/snell

// F0 + (1 - F0)(1 - cos)^5 (Schlick 1994), with the cosine on the rarer side: c itself, or sqrt(r) of refraction
// where wo is in the denser medium. So both directions through an interface see one F, and F = 1 from the
// critical angle on. An opaque material has eta = 1, hence c.
vec3 fresnel_schlick(Interaction at, float c) {
    float r = snell_radicand(at, c);
    float refracted = sqrt(max2(r, 0.0));
    float cosine = at.eta > 1.0 ? refracted : c;
    float x = max2(1.0 - cosine, 0.0);
    float x2 = x * x;
    vec3 f0 = at.material.f0;
    vec3 f = f0 + (vec3(1.0) - f0) * (x2 * x2 * x);
    return r <= 0.0 ? vec3(1.0) : f;
}
