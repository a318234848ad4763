// This scene has no null interfaces.

// Whether a shadow ray may continue beyond a hit: if not, any hit ends it.
const bool SHADOW_RAYS_PASS = false;

struct Skipped {
    Ray ray;
    vec3 factor;
};

bool is_null_interface(Hit hit) {
    return false;
}

Skipped skip_intersection(Ray ray, Hit hit) {
    return Skipped(ray, vec3(1.0));
}
