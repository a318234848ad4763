// Points on the faces of boxes.
// Twin of src/reference/shape/face.rs.

// uses: shape/face/point

// p, in the plane of face 2 axis + (1 for hi, 0 for lo).
FacePoint box_face_point(Cuboid cuboid, uint face, vec3 p) {
    uint axis = face / 2u;
    bool x = axis == 0u || (cuboid.lo.x <= p.x && p.x <= cuboid.hi.x);
    bool y = axis == 1u || (cuboid.lo.y <= p.y && p.y <= cuboid.hi.y);
    bool z = axis == 2u || (cuboid.lo.z <= p.z && p.z <= cuboid.hi.z);
    return FacePoint(x && y && z, vec2(0.0));
}
