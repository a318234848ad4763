// No mesh gives shading normals.
// Twin of the flat case of triangle_surface in src/reference/shape/triangle/mod.rs.

// uses:

vec3 shading_normal(uint prim, vec2 uv, vec3 ng) {
    return ng;
}
