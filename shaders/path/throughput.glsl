// The throughput of a path, and where it underflows.
// Twin of src/reference/path/throughput.rs.

// uses: math/vec, math/finite

// Whether t w underflows: some channel has light in both, and no channel has 2^-126 of it left.
bool underflows(vec3 t, vec3 w) {
    vec3 both = vec3(min2(t.x, w.x), min2(t.y, w.y), min2(t.z, w.z));
    return max_component(both) > 0.0 && max_component(t * w) < LEAST_NORMAL;
}

// t over its mean; 1 if the mean has underflowed.
vec3 channel_shares(vec3 t) {
    float mean = mean3(t);
    return mean >= LEAST_NORMAL ? t / mean : vec3(1.0);
}
