// A vertex of the path: the surface that a ray has hit, seen from the side it came from.
// uses: math/frame, shape/ray, bsdf/interaction, path/throughput, <surface>, <medium>, <valid>

struct Vertex {
    vec3 p;
    // Outward geometric normal.
    vec3 ng;
    // Geometric normal on wo's side.
    vec3 facing;
    // Whether wo is outside the shape.
    bool outside;
    // About N', the shading normal on wo's side.
    Frame frame;
    Interaction interaction;
    uint shape;
    uint prim;
    uint material;
};

// The vertex where `ray` has hit, `distance` away from the path's last vertex, with this `throughput`.
Vertex path_vertex(Ray ray, Hit hit, float distance, vec3 throughput) {
    Surface surface = hit_surface(ray, hit);
    vec3 wo = -ray.d;
    Vertex v;
    v.p = surface.p;
    v.ng = surface.ng;
    v.outside = dot3(wo, surface.ng) >= 0.0;
    v.facing = v.outside ? surface.ng : -surface.ng;
    v.shape = hit.shape;
    v.prim = hit.prim;
    v.material = shapes[v.shape].material;
    // The geometric normal decides the side; the shading normal makes only the frame (model.md, "Conventions").
    vec3 ns = dot3(surface.ns, v.facing) < 0.0 ? -surface.ns : surface.ns;
    v.frame = frame_about(seen_normal(ns, v.facing, wo, materials[v.material].kind));
    v.interaction = interaction(materials[v.material], v.outside, to_local(v.frame, wo),
                                term_attenuation(v.material, v.outside, distance));
    v.interaction.carried = channel_shares(throughput);
    return v;
}

// Whether a direction lies on the same side of the geometric and of the shading normal; elsewhere the BSDF is 0.
bool same_sides(Vertex v, vec3 wi, vec3 wi_local) {
    return (dot3(wi, v.facing) > 0.0) == (wi_local.z > 0.0);
}
