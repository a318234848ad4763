// Every surface of this scene is there.

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
