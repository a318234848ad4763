// Points on the parts of cylinders.
// Twin of src/reference/shape/face.rs.

// uses: constants/cylinder, math/frame, shape/cylinder, shape/face/point

// p, on the side, or in the plane of a cap.
FacePoint cylinder_face_point(Cylinder cylinder, uint part, vec3 p) {
    vec3 l = to_local(cylinder_frame(cylinder), p - cylinder.base);
    bool beside = 0.0 <= l.z && l.z <= cylinder.height;
    bool under = sqrt(l.x * l.x + l.y * l.y) <= cylinder.radius;
    return FacePoint(part == CYLINDER_SIDE ? beside : under, vec2(0.0));
}
