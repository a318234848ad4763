// Micro-normals from D(m) (m.N).
// Twin of src/reference/bsdf/normals/distribution.rs. Fills the slot <normals>.

// uses: bsdf/interaction, <distribution>

// A micro-normal from the material's own distribution.
vec3 normals_sample(Interaction at, vec2 u) {
    return distribution_sample(at.material, u);
}

// D(m) mz
float normals_pdf(Interaction at, vec3 m) {
    return distribution_d(at.material, m) * m.z;
}
