// Weights where light is found by connections alone, except the light that the camera and delta lobes see.

float connection_weight(float light_pdf, float bsdf_pdf) {
    return 1.0;
}

float hit_weight(bool delta, float bsdf_pdf, float light_pdf) {
    return delta ? 1.0 : 0.0;
}
