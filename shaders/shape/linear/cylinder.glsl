// The nearest hit among all cylinders, one after the other.
// Twin of nearest_cylinders in src/reference/shape/linear.rs.

// uses: math/steps, shape/ray, shape/cylinder, shape/linear/nearer

Hit nearest_cylinders(Ray ray, Target skip, Hit best) {
    Hit nearest = best;
    uint i = 0u;
    while (i < CYLINDERS) {
        loop_steps += 1u;
        uint shape = cylinders[i].shape;
        CylinderHit hit = cylinder_hit(ray.o, ray.d, cylinders[i], start_on(ray, shape), ray.prim);
        nearest = nearer_solid(hit.t, shape, hit.part, skip, nearest);
        i += 1u;
    }
    loop_failed = loop_failed || i < CYLINDERS;
    return nearest;
}
