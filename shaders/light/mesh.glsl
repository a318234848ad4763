// Meshes as lights. A mesh of `count` triangles from number `first` has count + 1 entries of triangle_cdf from `cdf`.
// Twin of src/reference/light/mesh.rs.

// uses: math/vec, shape/triangle/area, light/sample, light/triangle_choice, <triangles>

// A point of a mesh: the triangle by u24 < 2^24, then a point uniform in it.
//
// Both faces of a triangle emit. No triangle is excluded for facing away: whether another part of the mesh is in front
// of the point is left to the shadow ray.
LightSample mesh_light_sample(vec3 p, uint first, uint count, uint cdf, uint u24, vec2 u) {
    uint i = triangle_choice(cdf, count, u24);
    vec3 v0 = triangle_vertex(first + i, 0u);
    vec3 v1 = triangle_vertex(first + i, 1u);
    vec3 v2 = triangle_vertex(first + i, 2u);
    TriangleArea surface = triangle_area(v0, v1, v2);
    vec3 point = triangle_sample(v0, v1, v2, u);
    float density = triangle_pmf(cdf, i) * area_density(surface.area);
    return area_sample(point - p, surface.ng, density, first + i);
}

// Density of mesh_light_sample at a point of triangle `prim` that a path has hit at `distance` with the cosine |N_L.w|.
float mesh_light_pdf(uint first, uint cdf, uint prim, float distance, float cosine) {
    float area = triangle_area(triangle_vertex(prim, 0u), triangle_vertex(prim, 1u), triangle_vertex(prim, 2u)).area;
    float density = triangle_pmf(cdf, prim - first) * area_density(area);
    return solid_angle_pdf(density, distance, cosine);
}
