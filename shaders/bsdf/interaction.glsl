// A surface seen from one direction.
// Twin of src/reference/bsdf/interaction.rs.

// uses: math/vec

struct Interaction {
    Material material;
    // To the path's previous vertex, of unit length, in the frame of N': wo.z > 0, except for rays that just graze a
    // surface (0) and shading normals that turn away from them (below 0), where only Kd scatters.
    vec3 wo;
    // n_o / n_i
    float eta;
    // 1 - eta^2, rounded from f64: an eta near 1 has lost it.
    float one_minus_eta2;
    // (n_i / n_o)^2 - 1, rounded from f64.
    float d;
    // A(t) of the segment that led here inside the medium, with absorption by `term`; 1 otherwise.
    vec3 attenuation;
    // The path's throughput over its mean, by which the choice of lobe weighs channels; 1 unless the path sets it.
    vec3 carried;
};

// `material` seen from `wo`, which is on the outer side if `outside`.
Interaction interaction(Material material, bool outside, vec3 wo, vec3 attenuation) {
    Interaction at;
    at.material = material;
    at.wo = wo;
    at.eta = outside ? material.eta.x : material.eta.y;
    at.one_minus_eta2 = outside ? material.one_minus_eta2.x : material.one_minus_eta2.y;
    at.d = outside ? material.d.x : material.d.y;
    at.attenuation = attenuation;
    at.carried = vec3(1.0);
    return at;
}

// The mean of f weighted by the throughput, within [0, 1]; for a grey f it is f to the bit.
float carried_mean(Interaction at, vec3 f) {
    float mean = mean3(f);
    float weighted = mean + mean3(at.carried * (f - vec3(mean)));
    return min2(max2(weighted, 0.0), 1.0);
}
