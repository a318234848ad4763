// Micro-normals that wo sees, from the material's own distribution or nearly so.
// Twin of src/reference/bsdf/normals/visible/mod.rs. Fills the slot <normals>.

// uses: bsdf/interaction, <visible>

// A micro-normal; wo may just fail to see it.
vec3 normals_sample(Interaction at, vec2 u) {
    return visible_sample(at, u);
}

// Density with which it is drawn: for GGX and Beckmann D_wo(m) = G1(wo) max(0, wo.m) D(m)/wo.z (Heitz 2018, eq. 3).
float normals_pdf(Interaction at, vec3 m) {
    return visible_pdf(at, m);
}
