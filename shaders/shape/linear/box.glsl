// The box test of the search for the nearest hit.
// Twin of nearer_box in src/reference/shape/linear.rs.

// uses: constants/ray, shape/ray, shape/box, shape/linear/solid, <covered>

// The nearer of `best` and the hit with `cuboid`. A shadow ray's target is passed over.
Hit nearer_box(Ray ray, Target skip, Hit best, Cuboid cuboid) {
    BoxHit hit = box_hit(ray.o, ray.d, cuboid.lo, cuboid.hi, start_on(ray, cuboid.shape));
    if (box_covered(hit.t >= 0.0 && hit.t <= best.t, ray, cuboid.shape, hit.face, hit.t, box_enters(hit.face, ray.d))) {
        // The entry does not count: take the exit.
        hit = box_hit(ray.o, ray.d, cuboid.lo, cuboid.hi, START_INSIDE);
        hit.t = box_covered(true, ray, cuboid.shape, hit.face, hit.t, false) ? -1.0 : hit.t;
    }
    return nearer_solid(hit.t, cuboid.shape, hit.face, skip, best);
}
