// Arguments and results of sampling and evaluation.
// Twin of src/reference/bsdf/sample.rs.

// uses: constants/lobe, math/finite

// The random numbers of one draw, uniform in [0, 1).
struct BsdfRandom {
    // Between the diffuse lobe and the rest.
    float lobe;
    // Between reflection and refraction.
    float reflect;
    // The micro-normal.
    vec2 m;
    // The diffuse direction.
    vec2 d;
};

struct BsdfSample {
    // In the frame of N', of unit length.
    vec3 wi;
    // value |N.wi| / density, per channel.
    vec3 weight;
    // Density of wi per solid angle, over all lobes; meaningless for a delta lobe.
    float pdf;
    // LOBE_..., with LOBE_DELTA or without.
    uint lobe;
};

// The parts of a BSDF that have a density, for one pair of directions.
struct BsdfValue {
    // value |N.wi|, per channel.
    vec3 value;
    // Density of sampling wi per solid angle.
    float pdf;
};

// No direction.
BsdfSample no_sample() {
    return BsdfSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0, LOBE_NONE);
}

// No light goes this way.
BsdfValue no_value() {
    return BsdfValue(vec3(0.0), 0.0);
}

// `value`, or zero.
BsdfValue value_if(bool valid, BsdfValue value) {
    return BsdfValue(valid ? value.value : vec3(0.0), valid ? value.pdf : 0.0);
}

// The sample wi, unless it is invalid or its density is 0. A broken density breaks the weight: the film counts it.
BsdfSample sample_or_none(bool valid, vec3 wi, BsdfValue value, uint lobe) {
    bool found = valid && (value.pdf > 0.0 || !is_finite(value.pdf));
    BsdfSample s;
    s.wi = found ? wi : vec3(0.0, 0.0, 1.0);
    s.weight = found ? value.value / value.pdf : vec3(0.0);
    s.pdf = found ? value.pdf : 0.0;
    s.lobe = found ? lobe : LOBE_NONE;
    return s;
}
