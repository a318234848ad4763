// How far along a ray from a mesh its origin's rounding error reaches.
// uses: constants/shape_kind, shape/triangle/nearer

float self_distance(uint shape, vec3 p, vec3 ng, vec3 d) {
    float t = 0.0;
    if (shapes[shape].kind == SHAPE_MESH) {
        t = triangle_self_distance(p, ng, d);
    }
    return t;
}
