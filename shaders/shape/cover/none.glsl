// No two faces of the scene coincide. Fills the slot <cover>.
// uses: shape/ray

bool is_covered(bool asked, Ray ray, uint shape, uint prim, float t, bool enters) {
    return false;
}

bool is_covered_at(uint shape, uint prim, vec3 p) {
    return false;
}

Hit touching(Ray ray, Hit best) {
    return best;
}
