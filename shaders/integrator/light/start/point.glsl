// The first vertex of a light path.

// uses: light/emission/point

struct LightStart {
    Emission point;
    // L/(P p_A): radiance over the density of the point among those of all lights.
    vec3 radiance;
    // P p_A, that density.
    float pdf;
    uint light;
    uint shape;
    uint medium;
    // A light path begins here.
    bool emits;
};
