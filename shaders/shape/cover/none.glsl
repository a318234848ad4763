// No two faces of the scene coincide. Fills the slot <cover>.
// uses: shape/ray

bool is_covered_at(uint shape, uint prim, vec3 p) {
    return false;
}

Hit touching(Ray ray, Hit best) {
    return best;
}
