// The nearest hit among all spheres, one after the other.
// Twin of nearest_spheres in src/reference/shape/linear.rs.

// uses: math/steps, shape/ray, shape/sphere, shape/linear/nearer

Hit nearest_spheres(Ray ray, Target skip, Hit best) {
    Hit nearest = best;
    uint i = 0u;
    while (i < SPHERES) {
        loop_steps += 1u;
        uint shape = spheres[i].shape;
        float t = sphere_hit(ray.o, ray.d, spheres[i].centre, spheres[i].radius, start_on(ray, shape));
        nearest = nearer_solid(t, shape, 0u, skip, nearest);
        i += 1u;
    }
    loop_failed = loop_failed || i < SPHERES;
    return nearest;
}
