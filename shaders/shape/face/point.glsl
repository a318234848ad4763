// A point of a face's plane.
// Twin of src/reference/shape/face.rs.

// uses:

struct FacePoint {
    // On the face, including its edge.
    bool within;
    // Weights of a triangle's second and third corner.
    vec2 uv;
};
