// Surfaces of meshes.
// Twin of src/reference/shape/triangle/mod.rs.

// uses: shape/ray, shape/triangle/area, <triangles>, <shading_normal>

// The point that was hit, by its weights; the normal from the edges, the shading normal from those of the corners where
// the mesh gives any.
Surface triangle_surface(Hit hit) {
    vec3 v0 = triangle_vertex(hit.prim, 0u);
    vec3 v1 = triangle_vertex(hit.prim, 1u);
    vec3 v2 = triangle_vertex(hit.prim, 2u);
    vec3 ng = triangle_area(v0, v1, v2).ng;
    return Surface(triangle_point(v0, v1, v2, hit.uv), ng, shading_normal(hit.prim, hit.uv, ng));
}
