// Points of axis-aligned boxes.
// Twin of src/reference/light/emission/box.rs.

// uses: light/sample, light/emission/point

// Uniform over the six faces; the face is chosen by u24 < 2^24: first the lower faces across x, y and z, then the upper.
Emission box_emission(vec3 lo, vec3 hi, uint u24, vec2 u) {
    vec3 e = hi - lo;
    vec3 area = vec3(e.y * e.z, e.z * e.x, e.x * e.y);
    float lower = area.x + area.y + area.z;
    float choice = choice_below(u24, lower + lower);
    bool upper = choice >= lower;
    float rest = upper ? choice - lower : choice;
    bool x = rest < area.x;
    bool y = !x && rest < area.x + area.y;
    bool z = !x && !y;
    float side = upper ? 1.0 : 0.0;
    float out_of = upper ? 1.0 : -1.0;
    vec3 at = vec3(x ? side : u.x, y ? side : (x ? u.x : u.y), z ? side : u.y);
    vec3 n = vec3(x ? out_of : 0.0, y ? out_of : 0.0, z ? out_of : 0.0);
    uint prim = 2u * (x ? 0u : (y ? 1u : 2u)) + (upper ? 1u : 0u);
    return Emission(lo + e * at, n, area_density(lower + lower), prim);
}

// Whether p is beyond some face.
bool is_outside(vec3 p, vec3 lo, vec3 hi) {
    bool x = p.x < lo.x || hi.x < p.x;
    bool y = p.y < lo.y || hi.y < p.y;
    bool z = p.z < lo.z || hi.z < p.z;
    return x || y || z;
}

// Density per area of box_emission at a point that p sees; 0 from inside, where no light path goes.
float box_emission_pdf(vec3 p, vec3 lo, vec3 hi) {
    vec3 e = hi - lo;
    vec3 area = vec3(e.y * e.z, e.z * e.x, e.x * e.y);
    float lower = area.x + area.y + area.z;
    float density = area_density(lower + lower);
    return is_outside(p, lo, hi) ? density : 0.0;
}
