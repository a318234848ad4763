// Capped cylinders as lights.
// Twin of src/reference/light/cylinder.rs.

// uses: constants/cylinder, math/vec, math/frame, math/elementary/sincos, shape/cylinder, light/sample

const float PI = 3.141592653589793;

// The areas that are sampled from a point, given in the cylinder's frame.
struct CylinderArea {
    float side;
    float base;
    float top;
    // The point sees no part from outside: it is inside, or on the surface.
    bool inside;
};

// From outside, the caps that show their front, and from next to the cylinder the half of the side that faces the
// point; from inside, everything.
CylinderArea cylinder_area(vec3 p, float radius, float height) {
    bool beside = radius < sqrt(p.x * p.x + p.y * p.y);
    bool below = p.z < 0.0;
    bool above = height < p.z;
    bool inside = !beside && !below && !above;
    float half_side = PI * radius * height;
    float cap = PI * radius * radius;
    return CylinderArea(inside ? half_side + half_side : (beside ? half_side : 0.0), inside || below ? cap : 0.0,
                        inside || above ? cap : 0.0, inside);
}

// A point uniform over the areas of cylinder_area; the part is chosen by u24 < 2^24. Next to the cylinder, a point of
// that half may still show its back; it yields no sample: pdf 0.
LightSample cylinder_light_sample(vec3 p, Cylinder cylinder, uint u24, vec2 u) {
    Frame frame = cylinder_frame(cylinder);
    vec3 pl = to_local(frame, p - cylinder.base);
    CylinderArea area = cylinder_area(pl, cylinder.radius, cylinder.height);
    float total = area.side + area.base + area.top;
    float choice = choice_below(u24, total);
    bool on_side = choice < area.side;
    bool on_base = choice < area.side + area.base;
    bool half_turn = on_side && !area.inside;
    vec2 sincos = sincos_2pi(half_turn ? u.x * 0.5 : u.x);
    // Half a turn about the direction to p, or a whole turn.
    float rho = half_turn ? sqrt(pl.x * pl.x + pl.y * pl.y) : 1.0;
    float ex = half_turn ? pl.x / rho : 1.0;
    float ey = half_turn ? pl.y / rho : 0.0;
    float x = ex * sincos.x - ey * sincos.y;
    float y = ey * sincos.x + ex * sincos.y;
    float r = on_side ? cylinder.radius : cylinder.radius * sqrt(u.y);
    float z = on_side ? cylinder.height * u.y : (on_base ? 0.0 : cylinder.height);
    vec3 n = on_side ? vec3(x, y, 0.0) : vec3(0.0, 0.0, 1.0);
    vec3 to = vec3(x * r, y * r, z) - pl;
    uint part = on_side ? CYLINDER_SIDE : (on_base ? CYLINDER_BASE : CYLINDER_TOP);
    bool turned_away = half_turn && dot3(to, n) >= 0.0;
    LightSample result = area_sample(to, n, turned_away ? 0.0 : area_density(total), part);
    result.wi = to_world(frame, result.wi);
    return result;
}

// Density of cylinder_light_sample at a point that a path has hit at `distance` with the cosine |N_L.w|.
float cylinder_light_pdf(vec3 p, Cylinder cylinder, float distance, float cosine) {
    vec3 pl = to_local(cylinder_frame(cylinder), p - cylinder.base);
    CylinderArea area = cylinder_area(pl, cylinder.radius, cylinder.height);
    return solid_angle_pdf(area_density(area.side + area.base + area.top), distance, cosine);
}
