// Weight where light is found by paths that hit it, and in no other way.

float hit_weight(bool delta, float bsdf_pdf, float light_pdf) {
    return 1.0;
}
