// What a path sees that leaves the scene.
// Twin of src/reference/light/outside.rs.

// uses:

struct Outside {
    // W sr^-1 m^-2.
    vec3 radiance;
    // Per steradian: that with which the background as a light draws the direction.
    float pdf;
};
