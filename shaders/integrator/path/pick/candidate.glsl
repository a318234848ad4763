// A connection of a vertex to a point of one light, before the shadow ray.
// Twin of src/reference/integrator/path/pick/candidate.rs.
// uses: constants/none, math/finite, path/vertex, <light>, <bsdf>, <weigh>, <cover>

struct Candidate {
    // Index, or NONE if there is no light to pick.
    uint light;
    // wi, distance and face of the point.
    LightSample point;
    // Leads through the surface.
    bool through;
    // The light that arrives if nothing is in the way; black if the point cannot be seen or its light is not scattered.
    vec3 contribution;
};

Candidate no_candidate() {
    return Candidate(NONE, LightSample(vec3(0.0), -1.0, 0.0, 1.0, NONE), false, vec3(0.0));
}

// The point of `light` that u24 and u draw. `expected` is the average number of points drawn on this light, as given by
// pick_probability.
Candidate candidate(Subpath path, Vertex v, uint light, float expected, uint u24, vec2 u) {
    LightSample l = light_sample(light, v.p, u24, u);
    float p = expected * l.pdf;
    vec3 wi = to_local(v.frame, l.wi);
    Candidate c = Candidate(light, l, leads_through(wi), vec3(0.0));
    // A broken density breaks the contribution, which the film then drops and counts.
    bool covered = is_covered_at(lights[light].shape, l.prim, v.p + l.wi * l.distance);
    bool sampled = (p > 0.0 || !is_finite(p)) && !covered;
    if (sampled && same_sides(v.facing, l.wi, wi)) {
        BsdfValue f = bsdf_eval(v.interaction, wi);
        float weight = weigh(path, v, light, l, p, f.pdf);
        c.contribution = path.throughput * f.value * light_radiance(light, l.prim) * (weight / p);
    }
    return c;
}
