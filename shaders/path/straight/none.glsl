// Every surface of this scene is there.

struct Passage {
    vec3 o;
    uint start;
    float t_self;
    uint medium;
    vec3 factor;
};

bool goes_straight(Hit hit) {
    return false;
}

Passage pass(Ray ray, Hit hit) {
    return Passage(ray.o, ray.start, ray.t_self, NONE, vec3(1.0));
}
