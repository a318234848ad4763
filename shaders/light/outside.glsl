// The light outside the scene, seen by a path that leaves it.
// Twin of src/reference/light/outside.rs.

// uses:

struct Outside {
    // W sr^-1 m^-2.
    vec3 radiance;
    // Per steradian: the density with which the background as a light draws the direction.
    float pdf;
};
