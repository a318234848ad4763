// The cylinder test of the search for the nearest hit.
// Twin of nearer_cylinder in src/reference/shape/linear.rs.

// uses: constants/cylinder, constants/ray, shape/ray, shape/cylinder, shape/linear/solid, <covered>

// The nearer of `best` and the hit with `cylinder`. A shadow ray's target is passed over.
Hit nearer_cylinder(Ray ray, Target skip, Hit best, Cylinder cylinder) {
    CylinderHit hit = cylinder_hit(ray.o, ray.d, cylinder, start_on(ray, cylinder.shape), ray.prim);
    bool enters = cap_enters(cylinder, hit.part, ray.d);
    if (cylinder_covered(hit.t >= 0.0 && hit.t <= best.t, ray, cylinder.shape, hit.part, hit.t, enters)) {
        // The entry does not count: take the exit. A ray that starts on no part gets a cap as its start.
        hit = cylinder_hit(ray.o, ray.d, cylinder, START_INSIDE, CYLINDER_BASE);
        hit.t = cylinder_covered(true, ray, cylinder.shape, hit.part, hit.t, false) ? -1.0 : hit.t;
    }
    return nearer_solid(hit.t, cylinder.shape, hit.part, skip, best);
}
