// A sphere's part in the search for the nearest hit.
// Twin of nearer_sphere in src/reference/shape/linear.rs.

// uses: shape/ray, shape/sphere, shape/linear/solid

// The nearer of `best` and the hit with `sphere`. A shadow ray's target is passed over.
Hit nearer_sphere(Ray ray, Target skip, Hit best, Sphere sphere) {
    float t = sphere_hit(ray.o, ray.d, sphere.centre, sphere.radius, start_on(ray, sphere.shape));
    return nearer_solid(t, sphere.shape, 0u, skip, best);
}
