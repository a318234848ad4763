// Every surface of this scene is there.

struct Passage {
    Ray ray;
    vec3 factor;
};

bool goes_straight(Hit hit) {
    return false;
}

Passage pass(Ray ray, Hit hit) {
    return Passage(ray, vec3(1.0));
}
