// Capped cylinders.
// Twin of src/reference/shape/cylinder.rs.

// uses: constants/cylinder, constants/ray, math/vec, math/frame, shape/ray, shape/slab

// Distance to a cylinder, or -1, and the part hit.
struct CylinderHit {
    float t;
    uint part;
};

// The cylinder's own axes.
Frame cylinder_frame(Cylinder cylinder) {
    return Frame(cylinder.u, cylinder.v, cylinder.w);
}

// The interval of a ray inside the infinite cylinder x² + y² <= r², in the cylinder's frame.
//
// a t² - 2b t + c = 0 with a = dx² + dy², b = -(ox dx + oy dy), c = rho² - r² = (rho - r)(rho + r). The discriminant
// b² - a c cancels; it equals a r² - (ox dy - oy dx)², which does not. A ray that starts on the side to the inside has
// the roots 0 and 2b/a.
Slab side_stretch(vec3 o, vec3 d, float radius, uint start, uint part) {
    bool inside = start == START_INSIDE;
    float a = d.x * d.x + d.y * d.y;
    bool parallel = a < PARALLEL;
    float divisor = parallel ? 1.0 : a;
    float b = -(o.x * d.x + o.y * d.y);
    float rho = sqrt(o.x * o.x + o.y * o.y);
    float c = (rho - radius) * (rho + radius);
    float cross = o.x * d.y - o.y * d.x;
    float disc = a * (radius * radius) - cross * cross;
    float root = sqrt(max2(disc, 0.0));
    float q = b < 0.0 ? b - root : b + root;
    bool on_side = inside && part == CYLINDER_SIDE;
    float t0 = on_side || q == 0.0 ? 0.0 : c / q;
    float t1 = (on_side ? b + b : q) / divisor;
    bool within = inside || (parallel ? rho < radius : disc >= 0.0);
    float far = within ? FAR : -FAR;
    bool bounded = within && !parallel;
    return Slab(bounded ? min2(t0, t1) : -far, bounded ? max2(t0, t1) : far);
}

// The first hit with a capped cylinder along the unit vector d, or t = -1.
//
// `start` is the ray's relation to this cylinder, `part` the part that it starts on. If it leaves to the outside:
// never. To the inside: at the exit, t >= 0, always found. From elsewhere: the least t > 0. The solid is the
// intersection of an infinite cylinder with the space between two planes, and so are the ray's intervals.
CylinderHit cylinder_hit(vec3 o, vec3 d, Cylinder cylinder, uint start, uint part) {
    Frame frame = cylinder_frame(cylinder);
    vec3 ol = to_local(frame, o - cylinder.base);
    vec3 dl = to_local(frame, d);
    Slab side = side_stretch(ol, dl, cylinder.radius, start, part);
    Slab caps = slab(ol.z, dl.z, 0.0, cylinder.height, start);
    Slab stretch = Slab(max2(side.near, caps.near), min2(side.far, caps.far));
    bool entering = enters(stretch, start);
    bool by_side = entering ? side.near > caps.near : side.far < caps.far;
    uint cap = (dl.z > 0.0) == entering ? CYLINDER_BASE : CYLINDER_TOP;
    return CylinderHit(first_of(stretch, start), by_side ? CYLINDER_SIDE : cap);
}

// Whether a ray along d goes through a cap from outside; never called for the side, which touches no other solid.
bool cap_enters(Cylinder cylinder, uint part, vec3 d) {
    float along = dot3(d, cylinder.w);
    return part == CYLINDER_BASE ? along > 0.0 : (part == CYLINDER_TOP && along < 0.0);
}

// The point that was hit, in the cylinder's frame moved onto the part and within it.
Surface cylinder_surface(Ray ray, Hit hit, Cylinder cylinder) {
    Frame frame = cylinder_frame(cylinder);
    vec3 p = to_local(frame, ray.o - cylinder.base + ray.d * hit.t);
    bool on_side = hit.prim == CYLINDER_SIDE;
    bool on_base = hit.prim == CYLINDER_BASE;
    float rho = sqrt(p.x * p.x + p.y * p.y);
    // If the radius is below the resolution of the coordinates, take the side that faces the ray, or from within the
    // other one; any side if the ray runs along the axis.
    bool on_axis = rho == 0.0;
    bool leaves = start_on(ray, cylinder.shape) == START_INSIDE;
    vec3 along = to_local(frame, leaves ? ray.d : -ray.d);
    float across = sqrt(along.x * along.x + along.y * along.y);
    bool parallel = across == 0.0;
    float ex = parallel ? 1.0 : along.x / across;
    float ey = parallel ? 0.0 : along.y / across;
    float divisor = on_axis ? 1.0 : rho;
    float x = on_axis ? ex : p.x / divisor;
    float y = on_axis ? ey : p.y / divisor;
    float r = on_side ? cylinder.radius : min2(rho, cylinder.radius);
    float cap = on_base ? 0.0 : cylinder.height;
    float z = on_side ? min2(max2(p.z, 0.0), cylinder.height) : cap;
    vec3 side = frame.t * x + frame.b * y;
    vec3 n = on_side ? side : (on_base ? -cylinder.w : cylinder.w);
    return Surface(cylinder.base + (side * r + frame.n * z), n, n);
}
