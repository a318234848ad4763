// Points of meshes. A mesh of `count` triangles from number `first` has count + 1 entries of triangle_cdf from `cdf`.
// Twin of src/reference/light/emission/mesh.rs.

// uses: math/vec, shape/triangle/area, light/sample, light/triangle_choice, light/emission/point, <triangles>

// The triangle by u24 < 2^24, then a point uniform in it.
Emission mesh_emission(uint first, uint count, uint cdf, uint u24, vec2 u) {
    uint i = triangle_choice(cdf, count, u24);
    vec3 v0 = triangle_vertex(first + i, 0u);
    vec3 v1 = triangle_vertex(first + i, 1u);
    vec3 v2 = triangle_vertex(first + i, 2u);
    TriangleArea surface = triangle_area(v0, v1, v2);
    vec3 p = triangle_sample(v0, v1, v2, u);
    return Emission(p, surface.ng, triangle_pmf(cdf, i) * area_density(surface.area), first + i);
}

// Density per area of mesh_emission at a point of triangle `prim` that is seen along wi; 0 on the back, where no light path
// goes.
float mesh_emission_pdf(uint first, uint cdf, uint prim, vec3 wi) {
    TriangleArea surface = triangle_area(triangle_vertex(prim, 0u), triangle_vertex(prim, 1u), triangle_vertex(prim, 2u));
    float density = triangle_pmf(cdf, prim - first) * area_density(surface.area);
    return dot3(wi, surface.ng) < 0.0 ? density : 0.0;
}
