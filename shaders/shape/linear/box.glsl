// The nearest hit among all boxes, one after the other.
// Twin of nearest_boxes in src/reference/shape/linear.rs.

// uses: math/steps, shape/ray, shape/box, shape/linear/nearer

Hit nearest_boxes(Ray ray, Target skip, Hit best) {
    Hit nearest = best;
    uint i = 0u;
    while (i < BOXES) {
        loop_steps += 1u;
        uint shape = boxes[i].shape;
        BoxHit hit = box_hit(ray.o, ray.d, boxes[i].lo, boxes[i].hi, start_on(ray, shape));
        nearest = nearer_solid(hit.t, shape, hit.face, skip, nearest);
        i += 1u;
    }
    loop_failed = loop_failed || i < BOXES;
    return nearest;
}
