// Points of spheres.
// Twin of src/reference/light/emission/sphere.rs.

// uses: math/vec, light/sample, light/emission/point

// Uniform over the sphere, p_A = 1/(4pi r^2).
Emission sphere_emission(vec3 centre, float radius, vec2 u) {
    vec3 n = unit_sphere(u);
    return Emission(centre + n * radius, n, area_density(12.566370614359172 * (radius * radius)), 0u);
}

// Density per area of sphere_emission at a point that p sees; 0 from inside, where no light path goes.
float sphere_emission_pdf(vec3 p, vec3 centre, float radius) {
    float density = area_density(12.566370614359172 * (radius * radius));
    return length3(centre - p) > radius ? density : 0.0;
}
