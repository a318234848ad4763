// The watertight ray/triangle test.
// Twin of src/reference/shape/triangle/hit.rs.

// uses: math/vec, math/products

// The part of the test that depends only on a ray's direction: the axis along which it is longest becomes z, and the
// shear x - sx z, y - sy z maps the ray onto it.
struct RayShear {
    uint axis;
    float sx;
    float sy;
    // 1/d_z
    float sz;
};

// Distance to a triangle, or -1, and where: weights u, v of the second and third corner.
struct TriangleHit {
    float t;
    float u;
    float v;
    // Seen from behind: d.n > 0.
    bool back;
};

// The components in cyclic order, with `axis` last: orientation is preserved.
vec3 axis_last(vec3 v, uint axis) {
    return axis == 0u ? v.yzx : (axis == 1u ? v.zxy : v);
}

// The shear of a ray with direction d.
RayShear ray_shear(vec3 d) {
    float x = abs(d.x);
    float y = abs(d.y);
    float z = abs(d.z);
    uint axis = x >= y && x >= z ? 0u : (y >= z ? 1u : 2u);
    vec3 p = axis_last(d, axis);
    return RayShear(axis, p.x / p.z, p.y / p.z, 1.0 / p.z);
}

// The hit with a triangle from both sides, or t = -1.
//
// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013. A corner is sheared in the same
// way in every triangle it belongs to, and swapping two corners changes only the sign of an edge function,
// exactly. An edge function has the sign of the exact one of the sheared corners, and 0 counts as inside. So no
// ray passes between triangles that share an edge or a corner. A triangle whose sheared corners lie on a line
// has the sum 0 and is never hit.
//
// The edge functions must be accurate relative to themselves, not only to the products from which they are computed:
// otherwise a needle, or a triangle that is far smaller than its distance to the ray, is hit by rays that miss it by
// more than its size, and t is as wrong as its weights are.
TriangleHit triangle_hit(vec3 o, RayShear shear, vec3 v0, vec3 v1, vec3 v2) {
    vec3 a = axis_last(v0 - o, shear.axis);
    vec3 b = axis_last(v1 - o, shear.axis);
    vec3 c = axis_last(v2 - o, shear.axis);
    float ax = a.x - shear.sx * a.z;
    float ay = a.y - shear.sy * a.z;
    float bx = b.x - shear.sx * b.z;
    float by = b.y - shear.sy * b.z;
    float cx = c.x - shear.sx * c.z;
    float cy = c.y - shear.sy * c.z;
    // Twice the areas spanned by the ray and the edges opposite v0, v1, v2.
    float w0 = difference_of_products(bx, cy, by, cx);
    float w1 = difference_of_products(cx, ay, cy, ax);
    float w2 = difference_of_products(ax, by, ay, bx);
    bool positive = w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0;
    bool negative = w0 <= 0.0 && w1 <= 0.0 && w2 <= 0.0;
    float det = w0 + w1 + w2;
    float inverse = 1.0 / (det == 0.0 ? 1.0 : det);
    float t = (w0 * a.z + w1 * b.z + w2 * c.z) * shear.sz * inverse;
    bool found = (positive || negative) && det != 0.0 && t > 0.0;
    // det = (n.d)/d_z
    bool back = (det > 0.0) == (shear.sz > 0.0);
    return TriangleHit(found ? t : -1.0, w1 * inverse, w2 * inverse, back);
}
