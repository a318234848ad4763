// No mesh gives shading normals: all normals and directions are valid. Fills the slot <valid>.
// uses:

vec3 seen_normal(vec3 n, vec3 facing, vec3 wo, uint kind) {
    return n;
}

vec3 leaving_direction(vec3 n, vec3 facing, vec3 wi, float wi_z, uint lobe) {
    return wi;
}
