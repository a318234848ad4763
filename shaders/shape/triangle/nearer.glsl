// A triangle's part in the search for the nearest hit.
// Twin of src/reference/shape/triangle/nearer.rs.

// uses: shape/ray, shape/triangle/hit, shape/triangle/origin, <triangles>

// The nearer of `best` and the hit with triangle number `prim`. A shadow ray's target is passed over.
Hit nearer_triangle(Ray ray, RayShear shear, Target skip, Hit best, uint prim) {
    vec3 v0 = triangle_vertex(prim, 0u);
    vec3 v1 = triangle_vertex(prim, 1u);
    vec3 v2 = triangle_vertex(prim, 2u);
    TriangleHit hit = triangle_hit(ray.o, shear, v0, v1, v2);
    Hit nearer = best;
    if (hit.t > 0.0 && hit.t <= best.t && prim != skip.prim) {
        uint shape = triangle_shape(prim);
        if (closer(hit.t, shape, prim, best) && !is_origin(ray, v0, v1, v2, shape, prim, hit)) {
            nearer = Hit(hit.t, shape, prim, vec2(hit.u, hit.v));
        }
    }
    return nearer;
}
