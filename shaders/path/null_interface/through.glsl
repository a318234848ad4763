// Surfaces with |ior − 1| < 1e-7 are null interfaces: paths and shadow rays go straight through, attenuated (model.md,
// "The null interface"). No bounce is counted and no random number drawn.
// uses: constants/material_kind, constants/none, constants/ray, shape/ray, math/vec, <surface>, <self_distance>, <medium>

// Whether a shadow ray may continue beyond a hit: if not, any hit ends it.
const bool SHADOW_RAYS_PASS = true;

// The ray beyond the surface, and the attenuation that `term` applies on leaving.
struct Skipped {
    Ray ray;
    vec3 factor;
};

bool is_null_interface(Hit hit) {
    // Any shape will do if none is hit: an `if` around the two reads crashed Mesa 22.3's compiler in
    // kernels of one kind of shape.
    uint shape = hit.shape == NONE ? 0u : hit.shape;
    bool is_null = materials[shapes[shape].material].kind == KIND_NULL_INTERFACE;
    return is_null && hit.shape != NONE;
}

Skipped skip_intersection(Ray ray, Hit hit) {
    Surface surface = hit_surface(ray, hit);
    uint material = shapes[hit.shape].material;
    bool outside = dot3(ray.d, surface.ng) <= 0.0;
    Ray beyond = Ray(surface.p, ray.t_max - hit.t, ray.d, hit.shape, hit.prim, outside ? START_INSIDE : START_OUTSIDE,
                     self_distance(hit.shape, surface.p, surface.ng, ray.d), outside ? material : NONE);
    return Skipped(beyond, term_attenuation(material, outside, hit.t));
}
