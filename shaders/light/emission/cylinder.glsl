// Points of capped cylinders.
// Twin of src/reference/light/emission/cylinder.rs.

// uses: constants/cylinder, math/frame, math/elementary/sincos, shape/cylinder, light/sample, light/cylinder, light/emission/point

// Uniform over side, base and top, chosen by u24 < 2^24: 2pi r h, pi r^2 and pi r^2.
Emission cylinder_emission(Cylinder cylinder, uint u24, vec2 u) {
    float side = 6.283185307179586 * cylinder.radius * cylinder.height;
    float cap = 3.141592653589793 * cylinder.radius * cylinder.radius;
    float total = side + cap + cap;
    float choice = choice_below(u24, total);
    bool on_side = choice < side;
    bool on_base = !on_side && choice < side + cap;
    vec2 sincos = sincos_2pi(u.x);
    float r = on_side ? cylinder.radius : cylinder.radius * sqrt(u.y);
    float z = on_side ? cylinder.height * u.y : (on_base ? 0.0 : cylinder.height);
    vec3 n = on_side ? vec3(sincos.y, sincos.x, 0.0) : vec3(0.0, 0.0, on_base ? -1.0 : 1.0);
    uint part = on_side ? CYLINDER_SIDE : (on_base ? CYLINDER_BASE : CYLINDER_TOP);
    Frame frame = cylinder_frame(cylinder);
    vec3 p = cylinder.base + to_world(frame, vec3(sincos.y * r, sincos.x * r, z));
    return Emission(p, to_world(frame, n), area_density(total), part);
}

// Density per area of cylinder_emission at a point that p sees; 0 from inside, where no light path goes.
float cylinder_emission_pdf(vec3 p, Cylinder cylinder) {
    float side = 6.283185307179586 * cylinder.radius * cylinder.height;
    float cap = 3.141592653589793 * cylinder.radius * cylinder.radius;
    float density = area_density(side + cap + cap);
    vec3 pl = to_local(cylinder_frame(cylinder), p - cylinder.base);
    return cylinder_area(pl, cylinder.radius, cylinder.height).inside ? 0.0 : density;
}
