// Weights of light found in two ways: the power heuristic with exponent 2 (Veach, Robust Monte Carlo Methods for
// Light Transport Simulation, 1997, section 9.2.4), w = p²/(p² + q²), written 1/(1 + (q/p)²) against overflow.
// uses: math/vec

float power_heuristic(float p, float q) {
    float ratio = q / p;
    return 1.0 / (1.0 + ratio * ratio);
}

// Light found by a connection.
float connection_weight(float light_pdf, float bsdf_pdf) {
    return power_heuristic(light_pdf, bsdf_pdf);
}

// Light found by a hit; no connection could have found the light that a delta lobe or the camera sees.
float hit_weight(bool delta, float bsdf_pdf, float light_pdf) {
    return delta ? 1.0 : power_heuristic(bsdf_pdf, light_pdf);
}
