// Choice of a light from the table of counts out of 2^24.
// Twin of cdf_choice and cdf_probability in src/reference/light/choice.rs.

// uses: math/steps

// The light with light_cdf[i] <= u24 < light_cdf[i + 1], for u24 < 2^24.
uint light_choice(uint u24) {
    uint low = 0u;
    uint high = LIGHTS;
    while (high - low > 1u) {
        loop_steps += 1u;
        uint middle = (low + high) / 2u;
        bool below = light_cdf[middle] <= u24;
        low = below ? middle : low;
        high = below ? high : middle;
    }
    return low;
}

// The probability of that choice, exact.
float light_pmf(uint light) {
    return float(light_cdf[light + 1u] - light_cdf[light]) * 5.9604644775390625e-8;
}
