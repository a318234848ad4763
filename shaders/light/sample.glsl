// The result of a light sampler, and the functions that all of them share.
// Twin of src/reference/light/sample.rs.

// uses: math/vec, math/elementary/sincos

// A direction to a point of a light.
struct LightSample {
    // Unit length.
    vec3 wi;
    // To the point; -1: the background, beyond everything.
    float distance;
    // Per steradian; 0: no sample, and the other fields are meaningless.
    float pdf;
    // |N_L.wi| at the point.
    float cosine;
    // The face that the point is on, as in Hit: with the light's shape, the target of a shadow ray. For surroundings the texel.
    uint prim;
};

// 1/area; 0 for no area.
float area_density(float area) {
    bool some = area > 0.0;
    float density = 1.0 / (some ? area : 1.0);
    return some ? density : 0.0;
}

// p_w = p_A r²/|N_L.w|; 0 where the light is seen edge-on.
float solid_angle_pdf(float area_pdf, float distance, float cosine) {
    bool some = cosine > 0.0;
    float pdf = area_pdf * (distance * distance) / (some ? cosine : 1.0);
    return some ? pdf : 0.0;
}

// The sample at a point of a light with normal n, to = point - p, drawn with `area_pdf` per area.
LightSample area_sample(vec3 to, vec3 n, float area_pdf, uint prim) {
    float distance = length3(to);
    vec3 wi = to / (distance > 0.0 ? distance : 1.0);
    float cosine = abs(dot3(wi, n));
    return LightSample(wi, distance, solid_angle_pdf(area_pdf, distance, cosine), cosine, prim);
}

// A direction uniform over the unit sphere: z = 1 - 2 u1, sqrt(1 - z²) = 2 sqrt(u1 (1 - u1)).
vec3 unit_sphere(vec2 u) {
    float z = 1.0 - (u.x + u.x);
    float r = 2.0 * sqrt(u.x * (1.0 - u.x));
    vec2 sincos = sincos_2pi(u.y);
    return vec3(r * sincos.y, r * sincos.x, z);
}

// A choice in [0, total) from u24 < 2^24; rounding never reaches `total`.
float choice_below(uint u24, float total) {
    return float(u24) * 5.9604644775390625e-8 * total;
}
