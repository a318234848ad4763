// Points where light paths begin.
// Twin of src/reference/light/emission/mod.rs.

// uses: constants/none, light/sample

// A point of a light, uniform over its area.
struct Emission {
    vec3 p;
    // Outward, of unit length.
    vec3 n;
    // Density per area; 0: no light path begins here.
    float area_pdf;
    // The face that the point is on, as in Hit.
    uint prim;
};

// The background sends out no light paths.
Emission no_emission() {
    return Emission(vec3(0.0), vec3(0.0, 0.0, 1.0), 0.0, NONE);
}
