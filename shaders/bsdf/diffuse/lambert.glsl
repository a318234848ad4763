// The diffuse lobe.
// Twin of src/reference/bsdf/diffuse/lambert.rs.

// uses: math/elementary/sincos, bsdf/interaction, bsdf/sample

// A direction about N' with density cos theta/pi: a disc's point lifted to the hemisphere, sin^2 theta = u.
vec3 cosine_lobe(vec2 u) {
    vec2 phi = sincos_2pi(u.y);
    float sin_theta = sqrt(u.x);
    return vec3(sin_theta * phi.y, sin_theta * phi.x, sqrt(1.0 - u.x));
}

// value |N.wi| = Kd/pi wi.z, density wi.z/pi; zero on the far side.
BsdfValue lambert_lobe(Interaction at, vec3 wi) {
    float pdf = wi.z * 0.31830987;
    return value_if(wi.z > 0.0, BsdfValue(at.material.kd * pdf, pdf));
}
