// A ray that starts on a mesh, and the hits that are only its origin's rounding error.
// Twin of src/reference/shape/triangle/origin.rs.

// uses: constants/ray, math/vec, shape/ray, shape/triangle/area, shape/triangle/hit

// How far rounding may lift a ray's origin off its triangle, relative to the largest coordinate: 16 half-ulps, 16 *
// 2^-24. The Rust twin derives the number.
const float ORIGIN_ERROR = 9.5367431640625e-7;

// The distance along d within which a ray from p, on a triangle with normal ng, has not risen off that triangle by more
// than the rounding error of p.
float triangle_self_distance(vec3 p, vec3 ng, vec3 d) {
    float error = ORIGIN_ERROR * max_component(abs3(p));
    // Along the triangle: almost everywhere, and finite.
    return error / max2(abs(dot3(d, ng)), 1e-20);
}

// Whether a hit with triangle `prim` of `shape` is the ray's own origin again, lifted off its mesh by rounding.
//
// It is if it lies on the same triangle. On another triangle of the same mesh it is if the ray crosses it towards the
// side to which the ray has already left (a ray to the outside of a closed mesh cannot come out of it first, one to the
// inside cannot go in) and if, up to rounding, the ray is still in the plane in which it started, or also started in
// the plane of that triangle. A surface that the ray may truly meet first, such as a wall in a corner, therefore stops
// it at any distance.
bool is_origin(Ray ray, vec3 v0, vec3 v1, vec3 v2, uint shape, uint prim, TriangleHit hit) {
    vec3 n = cross3(v1 - v0, v2 - v0);
    float size = max2(max2(max_component(abs3(v0)), max_component(abs3(v1))),
                      max2(max_component(abs3(v2)), max_component(abs3(ray.o))));
    vec3 sum = abs3(n);
    float error = ORIGIN_ERROR * size * (sum.x + sum.y + sum.z);
    bool in_plane = hit.t <= ray.t_self || abs(dot3(n, v0 - ray.o)) <= error;
    bool leaves = hit.back == (ray.start == START_OUTSIDE);
    return shape == ray.shape && (prim == ray.prim || (leaves && in_plane));
}
