// A vertex of a light path joined to the eye: the light that arrives is a splat on the pixel that sees the vertex.
// Twin of src/reference/integrator/light/splat.rs.
// uses: constants/none, constants/path, math/finite, camera/eye, sampler/dimensions, integrator/light/begin, path/extend, path/spawn, path/vertex, <bsdf>, <correction>, <crossing>, <lens>

// Light on its way to a pixel.
struct SplatRay {
    // Not pending: the eye does not see the vertex, or nothing arrives.
    ShadowRay shadow;
    // row * width + column of the full picture.
    uint pixel;
};

// Whether a pixel is rendered.
bool in_film(EyeSample eye) {
    uint x = eye.column - job.film_x;
    uint y = eye.row - job.film_y;
    return eye.seen && x < job.film_width && y < job.film_height;
}

// A connection along `ray`, unless it contributes nothing or the eye does not see the vertex.
SplatRay splat_ray(EyeSample eye, Ray ray, vec3 contribution) {
    SplatRay splat;
    splat.shadow.ray = ray;
    splat.shadow.ray.t_max = eye.distance;
    splat.shadow.contribution = contribution;
    splat.shadow.target_shape = NONE;
    splat.shadow.target_prim = NONE;
    splat.shadow.pending = in_film(eye) && !is_black(contribution) ? 1u : 0u;
    splat.pixel = eye.row * camera.width + eye.column;
    return splat;
}

// The light itself, as the eye sees it: L cos W/(P p_A).
SplatRay splat_light(LightStart start, uint pixel_index, uint sample_index) {
    EyeSample eye = eye_drawn(pixel_index, sample_index, light_block(0u), start.point.p);
    float cosine = dot3(start.point.n, eye.wi);
    vec3 contribution = start.radiance * (cosine * eye.importance);
    bool seen = start.emits && cosine > 0.0;
    return splat_ray(eye, emitted_ray(start, eye.wi), seen ? contribution : vec3(0.0));
}

// A vertex that scatters: power throughput f W, f = value |N.wi| of the adjoint.
SplatRay splat_vertex(vec3 power, Subpath path, Vertex v, uint pixel_index, uint sample_index) {
    EyeSample eye = eye_drawn(pixel_index, sample_index, light_block(path.bounce + 1u), v.p);
    vec3 wi = to_local(v.frame, eye.wi);
    bool valid = eye.seen && same_sides(v.facing, eye.wi, wi);
    vec3 f = corrected(v, eye.wi, wi, bsdf_eval(v.interaction, wi).value);
    vec3 contribution = power * path.throughput * f * eye.importance;
    Ray ray = spawn_ray(v, eye.wi, leads_through(wi), path.ray.medium);
    return splat_ray(eye, ray, valid ? contribution : vec3(0.0));
}

// Leaves a connection to the eye pending.
void leave_pending(inout LightState s, inout ShadowRay shadow, SplatRay splat) {
    shadow = splat.shadow;
    s.pixel = splat.pixel;
    s.splat_sample = s.index - 1u;
}

// Counts the outcome of a path's extension.
void count_extension(Subpath path, Extension e, inout LightLane lane) {
    lane.underflows += e.underflow ? 1u : 0u;
    lane.long_paths += e.alive && path.bounce == LONG_PATH ? 1u : 0u;
    bool nan = e.broken && has_nan(path.throughput);
    lane.nan += nan ? 1u : 0u;
    lane.infinite += e.broken && !nan ? 1u : 0u;
}
