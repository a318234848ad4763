// Points of spheres.
// Twin of src/reference/light/emission/sphere.rs.

// uses: math/vec, light/sample, light/sphere, light/emission/point

// Uniform over the sphere, p_A = 1/(4pi r^2).
Emission sphere_emission(vec3 centre, float radius, vec2 u) {
    vec3 n = unit_sphere(u);
    return Emission(centre + n * radius, n, sphere_density(radius), 0u);
}

// Density per area of sphere_emission at a point that p sees; 0 from inside, where no light path goes.
float sphere_emission_pdf(vec3 p, vec3 centre, float radius) {
    float density = sphere_density(radius);
    return length3(centre - p) > radius ? density : 0.0;
}
