// The nearest hit among all triangles, one after the other.
// Twin of nearest_triangles in src/reference/shape/linear.rs.

// uses: math/steps, shape/ray, shape/triangle/hit, shape/triangle/nearer

Hit nearest_triangles(Ray ray, Target skip, Hit best) {
    RayShear shear = ray_shear(ray.d);
    Hit nearest = best;
    uint i = 0u;
    while (i < TRIANGLES) {
        loop_steps += 1u;
        nearest = nearer_triangle(ray, shear, skip, nearest, i);
        i += 1u;
    }
    loop_failed = loop_failed || i < TRIANGLES;
    return nearest;
}
