// The sphere test of the search for the nearest hit.
// Twin of nearer_sphere in src/reference/shape/linear.rs.

// uses: shape/ray, shape/sphere, shape/linear/solid, <covered>

// The nearer of `best` and the hit with `sphere`. A shadow ray's target is passed over.
Hit nearer_sphere(Ray ray, Target skip, Hit best, Sphere sphere) {
    float t = sphere_hit(ray.o, ray.d, sphere.centre, sphere.radius, start_on(ray, sphere.shape));
    // A shape that comes first at one point of a sphere comes first at all of them.
    bool covered = sphere_covered(t >= 0.0 && t <= best.t, ray, sphere.shape, 0u, t, false);
    return nearer_solid(covered ? -1.0 : t, sphere.shape, 0u, skip, best);
}
