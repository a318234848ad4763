// A cylinder's part in the search for the nearest hit.
// Twin of nearer_cylinder in src/reference/shape/linear.rs.

// uses: shape/ray, shape/cylinder, shape/linear/solid

// The nearer of `best` and the hit with `cylinder`. A shadow ray's target is passed over.
Hit nearer_cylinder(Ray ray, Target skip, Hit best, Cylinder cylinder) {
    CylinderHit hit = cylinder_hit(ray.o, ray.d, cylinder, start_on(ray, cylinder.shape), ray.prim);
    return nearer_solid(hit.t, cylinder.shape, hit.part, skip, best);
}
