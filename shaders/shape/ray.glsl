// Rays, hits, surfaces, and the order among hits.
// Twin of src/reference/shape/ray.rs; struct Ray comes with the layout of buffers.

// uses: constants/none, constants/ray

// The target of a shadow ray, which must not stop it: a solid, or one triangle of a mesh.
struct Target {
    uint shape;
    uint prim;
};

// Where a ray meets a shape.
struct Hit {
    // Distance; the limit of the search if nothing is hit.
    float t;
    // NONE: nothing is hit.
    uint shape;
    // Triangle (index among all), face of a box, part of a cylinder, 0 for a sphere.
    uint prim;
    // Weights of a triangle's second and third corner.
    vec2 uv;
};

// A point of a surface.
struct Surface {
    // On the surface, as exactly as a float allows.
    vec3 p;
    // Outward geometric normal, unit length.
    vec3 ng;
    // Shading normal on the side of ng, unit length.
    vec3 ns;
};

// Nothing is hit before t_max.
Hit no_hit(float t_max) {
    return Hit(t_max, NONE, NONE, vec2(0.0));
}

// Whether a hit comes before `best`: the least (t, shape, prim), in lexicographic order (model.md, "Order of hits").
// Before the first hit it must come before the limit, best.t.
bool closer(float t, uint shape, uint prim, Hit best) {
    bool before = shape < best.shape || (shape == best.shape && prim < best.prim);
    return t < best.t || (t == best.t && best.shape != NONE && before);
}

// How the ray starts relative to `shape`.
uint start_on(Ray ray, uint shape) {
    return shape == ray.shape ? ray.start : START_ELSEWHERE;
}
