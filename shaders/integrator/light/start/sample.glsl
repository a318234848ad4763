// A light, and a point of it. Fills the slot <light_start>.
// Twin of src/reference/integrator/light/begin.rs.
// uses: math/finite, sampler/dimensions, sampler/unit_float, integrator/light/start/point, <sampler>, <blocks>, <light_choice>, <light_emission>, <cover>

LightStart light_start(uint pixel_index, uint sample_index) {
    uvec4 u = sampler_block(pixel_index, sample_index, path_block(camera_block()), camera.seed);
    uint light = light_choice(u.x >> 8u);
    LightStart start;
    start.point = light_emission(light, u.y >> 8u, vec2(unit_float(u.z), unit_float(u.w)));
    float p = light_pmf(light) * start.point.area_pdf;
    // A broken density breaks the quotient, which the film then drops and counts.
    bool covered = is_covered_at(lights[light].shape, start.point.prim, start.point.p);
    start.emits = (p > 0.0 || !is_finite(p)) && !covered;
    start.radiance = lights[light].radiance / (start.emits ? p : 1.0);
    start.pdf = p;
    start.light = light;
    start.shape = start.emits ? lights[light].shape : 0u;
    start.medium = light_media[light];
    return start;
}
