// A box's part in the search for the nearest hit.
// Twin of nearer_box in src/reference/shape/linear.rs.

// uses: shape/ray, shape/box, shape/linear/solid

// The nearer of `best` and the hit with `cuboid`. A shadow ray's target is passed over.
Hit nearer_box(Ray ray, Target skip, Hit best, Cuboid cuboid) {
    BoxHit hit = box_hit(ray.o, ray.d, cuboid.lo, cuboid.hi, start_on(ray, cuboid.shape));
    return nearer_solid(hit.t, cuboid.shape, hit.face, skip, best);
}
