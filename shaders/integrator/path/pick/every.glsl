// A light picked among few by its contribution. Fills the slot <pick>.
// Twin of src/reference/integrator/path/pick/every.rs.
// uses: math/vec, math/finite, math/steps, sampler/unit_float, integrator/path/pick/candidate

// Every light gets a point, from the same numbers shifted by multiples of the golden ratio, so that each light's points are
// spread as the sampler's are. One of the candidates is kept with the probability w/W, where W is the sum of all w, and
// represents all by the factor W/w (Talbot et al., Importance Resampling for Global Illumination, EGSR 2005, section 3, with
// every light sampled once; one pass: Chao, A General Purpose Unequal Probability Sampling Plan, Biometrika 69(3), 1982).
Candidate pick_every(Subpath path, Vertex v, uvec4 u) {
    Candidate kept = no_candidate();
    float choice = unit_float(u.x);
    float total = 0.0;
    float own = 0.0;
    uint light = 0u;
    while (light < LIGHTS) {
        loop_steps += 1u;
        uint turn = light * 0x9e3779b9u;
        vec2 point = vec2(unit_float(u.z + turn), unit_float(u.w + turn));
        Candidate c = candidate(path, v, light, 1.0, (u.y + turn) >> 8u, point);
        float w = mean3(c.contribution);
        total += w;
        // The share of this one among those so far. The rest of the number is uniform again.
        float share = w / total;
        bool takes = choice < share;
        float rest = takes ? choice / share : (choice - share) / (1.0 - share);
        choice = w > 0.0 ? rest : choice;
        takes = takes || !is_finite(w);
        own = takes ? w : own;
        if (takes) {
            kept = c;
        }
        light += 1u;
    }
    kept.contribution *= kept.light == NONE ? 0.0 : total / own;
    return kept;
}
