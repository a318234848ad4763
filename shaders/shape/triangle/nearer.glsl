// The triangle test of the search for the nearest hit.
// Twin of src/reference/shape/triangle/nearer.rs.

// uses: shape/ray, shape/triangle/hit, shape/triangle/origin, <triangles>, <covered>

// The nearer of `best` and the hit with `triangle`, which is number `prim`. A shadow ray's target is passed over.
Hit nearer_triangle(Ray ray, RayShear shear, Target skip, Hit best, Triangle triangle, uint prim) {
    TriangleHit hit = triangle_hit(ray.o, shear, triangle.v0, triangle.v1, triangle.v2);
    bool nearer = false;
    uint shape = triangle.shape;
    if (hit.t > 0.0 && hit.t <= best.t && !(shape == skip.shape && prim == skip.prim)) {
        nearer = closer(hit.t, shape, prim, best)
            && !is_origin(ray, triangle.v0, triangle.v1, triangle.v2, shape, prim, hit);
    }
    bool covered = mesh_covered(nearer, ray, shape, prim, hit.t, !hit.back);
    Hit result = best;
    if (nearer && !covered) {
        result = Hit(hit.t, shape, prim, vec2(hit.u, hit.v));
    }
    return result;
}
