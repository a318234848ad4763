// Shading normals of meshes that give any.
// Twin of src/reference/shape/normal.rs.

// uses: math/vec, <triangles>

// The corners' normals by the hit's weights, turned to the side of ng; ng where they are 0.
vec3 interpolated_normal(vec3 n0, vec3 n1, vec3 n2, vec2 uv, vec3 ng) {
    vec3 n = n0 * (1.0 - uv.x - uv.y) + n1 * uv.x + n2 * uv.y;
    float length = length3(n);
    bool flat_shaded = length == 0.0;
    vec3 unit = n / (flat_shaded ? 1.0 : length);
    return flat_shaded ? ng : (dot3(unit, ng) < 0.0 ? -unit : unit);
}

// The shading normal of triangle `prim` at the weights uv.
vec3 shading_normal(uint prim, vec2 uv, vec3 ng) {
    return interpolated_normal(triangle_normal(prim, 0u), triangle_normal(prim, 1u), triangle_normal(prim, 2u), uv, ng);
}
