// A vertex of the eye path joined to one of the light path.
// Twin of src/reference/integrator/bidirectional/join.rs.
// uses: math/finite, math/vec, path/spawn, path/origin, path/vertex, integrator/bidirectional/bend, integrator/bidirectional/joint, integrator/bidirectional/partial, <crossing>, <depth>

// Whether a direction leads into the solid that the vertex is on.
bool looks_inside(Vertex v, bool through) {
    return v.outside == through;
}

// The connection along wi, the direction in which `from` sees `to`: it must arrive in the medium that `to` faces.
ShadowRay connection(Joint from, vec3 wi, bool through, Joint to, bool to_through, float distance, vec3 contribution) {
    Ray ray = spawn_ray(from.v, wi, through, from.medium);
    ray.t_max = distance;
    return ShadowRay(ray, contribution, 1u, to.v.shape, to.v.prim, medium_after(to.v, to_through, to.medium), 0u);
}

// The light that may arrive at the eye via y, on the light path, and x, on the eye path: f_x f_y/d² times the
// throughput and power that they carry, for `share` vertices like y. Not pending where they cannot be connected.
ShadowRay join(Joint x, Joint y, float share) {
    ShadowRay shadow;
    shadow.pending = 0u;
    vec3 to = y.v.p - x.v.p;
    float distance = length3(to);
    vec3 wi = to / (distance > 0.0 ? distance : 1.0);
    Bend at_x = bend(x.v, x.wo, wi);
    from_light = true;
    Bend at_y = bend(y.v, y.wo, -wi);
    from_light = false;
    float w = vertex_weight(x.partial, at_x.junction, y.partial, at_y.junction, distance);
    vec3 contribution = x.carried * at_x.f * (y.carried * at_y.f) * (w / (distance * distance) * share);
    // A path of n bounces has n + 2 vertices.
    bool short_enough = !depth_reached(x.count + y.count - 3u);
    if (distance > 0.0 && short_enough && at_x.some && at_y.some && !is_black(contribution)) {
        // A target is a whole solid, which cannot hide its own inside from a ray that comes from outside: such a ray
        // goes the other way, and meets the solid's far side.
        if (looks_inside(y.v, at_y.through)) {
            shadow = connection(y, -wi, at_y.through, x, at_x.through, distance, contribution);
        } else {
            shadow = connection(x, wi, at_x.through, y, at_y.through, distance, contribution);
        }
    }
    return shadow;
}
