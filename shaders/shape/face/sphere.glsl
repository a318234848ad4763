// Points on spheres.
// Twin of src/reference/shape/face.rs.

// uses: shape/face/point

// Every point of the sphere.
FacePoint sphere_face_point() {
    return FacePoint(true, vec2(0.0));
}
