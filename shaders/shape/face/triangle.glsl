// Points on triangles.
// Twin of src/reference/shape/face.rs.

// uses: math/vec, math/products, shape/triangle/area, shape/triangle/hit, shape/face/point

// p, in the triangle's plane: seen along the axis that is nearest to the normal, by the signs of the edge functions
// (`triangle_hit`), so that no point falls between two triangles that share an edge.
FacePoint triangle_face_point(vec3 v0, vec3 v1, vec3 v2, vec3 p) {
    vec3 n = abs3(cross3(v1 - v0, v2 - v0));
    uint axis = n.x >= n.y && n.x >= n.z ? 0u : (n.y >= n.z ? 1u : 2u);
    vec3 a = axis_last(v0 - p, axis);
    vec3 b = axis_last(v1 - p, axis);
    vec3 c = axis_last(v2 - p, axis);
    float w0 = difference_of_products(b.x, c.y, b.y, c.x);
    float w1 = difference_of_products(c.x, a.y, c.y, a.x);
    float w2 = difference_of_products(a.x, b.y, a.y, b.x);
    bool positive = w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0;
    bool negative = w0 <= 0.0 && w1 <= 0.0 && w2 <= 0.0;
    float det = w0 + w1 + w2;
    float inverse = 1.0 / (det == 0.0 ? 1.0 : det);
    return FacePoint((positive || negative) && det != 0.0, vec2(w1 * inverse, w2 * inverse));
}
