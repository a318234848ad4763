// The only light of a scene.

// uses:

uint light_choice(uint u24) {
    return 0u;
}

float light_pmf(uint light) {
    return 1.0;
}
