// A vertex of a light path joined to the eye: what arrives there is a splat on the pixel that sees the vertex.
// Twin of src/reference/integrator/light/splat.rs.
// uses: constants/none, math/finite, camera/eye, integrator/light/begin, path/spawn, path/vertex, <bsdf>, <correction>, <crossing>

// Whether a pixel is among those that are rendered.
bool in_film(EyeSample eye) {
    uint x = eye.column - job.film_x;
    uint y = eye.row - job.film_y;
    return eye.seen && x < job.film_width && y < job.film_height;
}

// Leaves a connection pending along `ray`, unless it brings nothing or the eye does not see the vertex.
ShadowRay splat_ray(inout LightState s, EyeSample eye, Ray ray, vec3 contribution) {
    ShadowRay shadow;
    shadow.ray = ray;
    shadow.ray.t_max = eye.distance;
    shadow.contribution = contribution;
    shadow.target_shape = NONE;
    shadow.target_prim = NONE;
    bool pending = in_film(eye) && !is_black(contribution);
    shadow.pending = pending ? 1u : 0u;
    s.pixel = pending ? eye.row * camera.width + eye.column : s.pixel;
    s.splat_sample = pending ? s.index - 1u : s.splat_sample;
    return shadow;
}

// The light itself, as the eye sees it: L cos W/(P p_A).
ShadowRay splat_light(inout LightState s, LightStart start) {
    EyeSample eye = eye_sample(camera, start.point.p);
    float cosine = dot3(start.point.n, eye.wi);
    vec3 contribution = start.radiance * (cosine * eye.importance);
    bool seen = start.emits && cosine > 0.0;
    return splat_ray(s, eye, emitted_ray(start, eye.wi), seen ? contribution : vec3(0.0));
}

// A vertex that scatters: power throughput f W, f = value |N.wi| of the adjoint.
ShadowRay splat_vertex(inout LightState s, Subpath path, Vertex v) {
    EyeSample eye = eye_sample(camera, v.p);
    vec3 wi = to_local(v.frame, eye.wi);
    bool valid = eye.seen && same_sides(v, eye.wi, wi);
    vec3 f = corrected(v, eye.wi, wi, bsdf_eval(v.interaction, wi).value);
    vec3 contribution = s.power * path.throughput * f * eye.importance;
    Ray ray = spawn_ray(v, eye.wi, leads_through(wi), path.ray.medium);
    return splat_ray(s, eye, ray, valid ? contribution : vec3(0.0));
}
