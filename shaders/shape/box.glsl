// Axis-aligned boxes.
// Twin of src/reference/shape/box.rs.

// uses: math/vec, shape/ray, shape/slab

// Distance to a box, or -1, and the face hit: 2 axis + (1 for hi, 0 for lo).
struct BoxHit {
    float t;
    uint face;
};

// The face on the side of d across axis x, else y, else z.
uint box_face(bool x, bool y, vec3 d) {
    float along = x ? d.x : (y ? d.y : d.z);
    uint axis = x ? 0u : (y ? 1u : 2u);
    return 2u * axis + (along > 0.0 ? 1u : 0u);
}

// The first hit with a box along the unit vector d, or t = -1.
//
// `start` is the ray's relation to this box. If it leaves to the outside: never. To the inside: at the exit, t >= 0,
// always found. From elsewhere: the least t > 0, so that a ray which starts in the plane of a face is not stopped
// there. Slabs: Kay and Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986.
BoxHit box_hit(vec3 o, vec3 d, vec3 lo, vec3 hi, uint start) {
    Slab x = slab(o.x, d.x, lo.x, hi.x, start);
    Slab y = slab(o.y, d.y, lo.y, hi.y, start);
    Slab z = slab(o.z, d.z, lo.z, hi.z, start);
    float near = max2(max2(x.near, y.near), z.near);
    float far = min2(min2(x.far, y.far), z.far);
    Slab stretch = Slab(near, far);
    uint entry = box_face(x.near == near, y.near == near, -d);
    uint exit = box_face(x.far == far, y.far == far, d);
    return BoxHit(first_of(stretch, start), enters(stretch, start) ? entry : exit);
}

// Whether a ray along d goes through a face from outside.
bool box_enters(uint face, vec3 d) {
    uint axis = face / 2u;
    float along = axis == 0u ? d.x : (axis == 1u ? d.y : d.z);
    return (along > 0.0) == (face % 2u == 0u);
}

// The coordinate of a point of a face: the face plane's along the axis `across` it, clamped to the face along the others.
float box_snap(bool across, bool upper, float p, float lo, float hi) {
    return across ? (upper ? hi : lo) : min2(max2(p, lo), hi);
}

// The point that was hit, exactly on the face's plane and within the face.
Surface box_surface(Ray ray, Hit hit, Cuboid cuboid) {
    vec3 lo = cuboid.lo;
    vec3 hi = cuboid.hi;
    vec3 p = ray.o + ray.d * hit.t;
    uint axis = hit.prim / 2u;
    bool upper = hit.prim % 2u == 1u;
    float sign = upper ? 1.0 : -1.0;
    vec3 n = vec3(axis == 0u ? sign : 0.0, axis == 1u ? sign : 0.0, axis == 2u ? sign : 0.0);
    vec3 snapped = vec3(box_snap(axis == 0u, upper, p.x, lo.x, hi.x), box_snap(axis == 1u, upper, p.y, lo.y, hi.y),
                        box_snap(axis == 2u, upper, p.z, lo.z, hi.z));
    return Surface(snapped, n, n);
}
