// The next direction of a path at a vertex.
// Twin of src/reference/path/extend.rs.
// uses: constants/lobe, math/finite, path/vertex, path/spawn, path/throughput, sampler/dimensions, sampler/unit_float, sampler/chance, <sampler>, <blocks>, <bsdf>, <valid>, <correction>, <crossing>, <roulette>

// The outcome of an extension.
struct Extension {
    bool alive;
    // The throughput is below the least that f32 can represent.
    bool underflow;
    // The throughput is NaN or infinite.
    bool broken;
    // LOBE_… of the direction.
    uint lobe;
};

// Draws the next direction and moves the path onto it, if there is one.
Extension extend(inout Subpath path, Vertex v, uint pixel_index, uint sample_index) {
    uvec4 u = sampler_block(pixel_index, sample_index, path_block(bsdf_block(path.bounce)), camera.seed);
    uvec4 w = sampler_block(pixel_index, sample_index, path_block(roulette_block(path.bounce)), camera.seed);
    BsdfRandom random = BsdfRandom(unit_float(u.x), unit_float(u.y), vec2(unit_float(u.z), unit_float(u.w)),
                                   vec2(unit_float(w.y), unit_float(w.z)));
    BsdfSample b = bsdf_sample(v.interaction, random);
    vec3 wi = leaving_direction(v.frame.n, v.facing, to_world(v.frame, b.wi), b.wi.z, b.lobe);
    bool found = b.lobe != LOBE_NONE && same_sides(v.facing, wi, b.wi);
    vec3 weight = corrected(v, wi, b.wi, b.weight);
    bool faint = underflows(path.throughput, weight);
    path.throughput *= weight;
    bool through = leads_through(b.wi);
    path.eta_scale *= crossing_scale(v, through);
    float survival = chance(roulette_survival(path.throughput, path.eta_scale, path.bounce));
    bool survives = unit_float(w.x) < survival;
    bool alive = found && survives && !(faint || is_black(path.throughput));
    path.throughput *= alive ? 1.0 / survival : 1.0;
    bool broken = !is_finite3(path.throughput);
    alive = alive && !broken;
    if (alive) {
        path.ray = spawn_ray(v, wi, through, path.ray.medium);
        path.pdf = b.pdf;
        path.delta = b.lobe >= LOBE_DELTA ? 1u : 0u;
        path.bounce += 1u;
    }
    return Extension(alive, found && faint, broken, b.lobe);
}
