// A vertex of the path: the surface that a ray has hit, seen from the side it came from.
// uses: math/frame, shape/ray, bsdf/interaction, path/throughput, <surface>, <medium>, <valid>

struct Vertex {
    vec3 p;
    // Outward geometric normal.
    vec3 ng;
    // Shading normal on the side of ng, as the surface defines it.
    vec3 ns;
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

// A surface of normals ng and ns, seen along wo, which leads away from it.
struct Seen {
    bool outside;
    vec3 facing;
    Frame frame;
    Interaction interaction;
};

Seen seen_from(Material material, vec3 ng, vec3 ns, vec3 wo) {
    Seen seen;
    seen.outside = dot3(wo, ng) >= 0.0;
    seen.facing = seen.outside ? ng : -ng;
    // The geometric normal decides the side; the shading normal makes only the frame (model.md, "Conventions").
    vec3 shading = dot3(ns, seen.facing) < 0.0 ? -ns : ns;
    seen.frame = frame_about(seen_normal(shading, seen.facing, wo, material.kind));
    seen.interaction = interaction(material, seen.outside, to_local(seen.frame, wo), vec3(1.0));
    return seen;
}

// The point `surface` of a shape, seen along wo.
Vertex vertex_at(Surface surface, uint shape, uint prim, vec3 wo) {
    uint material = shapes[shape].material;
    Seen seen = seen_from(materials[material], surface.ng, surface.ns, wo);
    return Vertex(surface.p, surface.ng, surface.ns, seen.facing, seen.outside, seen.frame, seen.interaction, shape, prim,
                  material);
}

// The vertex where `ray` has hit, `distance` away from the path's last vertex, with this `throughput`.
Vertex path_vertex(Ray ray, Hit hit, float distance, vec3 throughput) {
    Vertex v = vertex_at(hit_surface(ray, hit), hit.shape, hit.prim, -ray.d);
    v.interaction.attenuation = term_attenuation(v.material, v.outside, distance);
    v.interaction.carried = channel_shares(throughput);
    return v;
}

// Whether a direction lies on the same side of the geometric and of the shading normal; elsewhere the BSDF is 0.
bool same_sides(vec3 facing, vec3 wi, vec3 wi_local) {
    return (dot3(wi, facing) > 0.0) == (wi_local.z > 0.0);
}
