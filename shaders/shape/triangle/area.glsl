// Points, normal and area of a triangle.
// Twin of src/reference/shape/triangle/area.rs.

// uses: math/vec

// Unit normal of a triangle, and its area.
struct TriangleArea {
    vec3 ng;
    float area;
};

// |x|, |y|, |z|
vec3 abs3(vec3 v) {
    return vec3(abs(v.x), abs(v.y), abs(v.z));
}

// v0 + (u e1 + v e2): only one rounding has the size of the coordinates.
vec3 triangle_point(vec3 v0, vec3 v1, vec3 v2, vec2 uv) {
    return v0 + ((v1 - v0) * uv.x + (v2 - v0) * uv.y);
}

// A point uniform in the triangle: the square folded onto it, sqrt(u1) is the share of the way from v0 to its opposite edge.
vec3 triangle_sample(vec3 v0, vec3 v1, vec3 v2, vec2 u) {
    float s = sqrt(u.x);
    return triangle_point(v0, v1, v2, vec2(s * (1.0 - u.y), s * u.y));
}

// e1 x e2 = 2 area ng, for edges scaled to a size of 1, so that neither small nor large ones leave the range of a
// float. A triangle without area gets area 0 and the normal (0, 0, 1).
TriangleArea triangle_area(vec3 v0, vec3 v1, vec3 v2) {
    vec3 e1 = v1 - v0;
    vec3 e2 = v2 - v0;
    float size = max2(max_component(abs3(e1)), max_component(abs3(e2)));
    float scale = 1.0 / (size == 0.0 ? 1.0 : size);
    vec3 n = cross3(e1 * scale, e2 * scale);
    float length = length3(n);
    bool empty = length == 0.0;
    vec3 unit = n / (empty ? 1.0 : length);
    return TriangleArea(empty ? vec3(0.0, 0.0, 1.0) : unit, 0.5 * length * size * size);
}
