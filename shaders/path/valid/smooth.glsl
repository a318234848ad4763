// Shading normals that wo sees, and delta directions that leave the face on the intended side (model.md, "Valid shading
// normals"). Fills the slot <valid>.
// Twin of src/reference/path/valid.rs.
// uses: constants/lobe, constants/material_kind, math/vec

// The least wo.n of a normal.
const float SEEN = 1e-3;
// Height over the face of a direction that had to be lifted.
const float LIFT = 1e-2;

// The shading normal n of a surface that mirrors or refracts, turned just enough that wo sees it.
//
// n + (SEEN - wo.n) wo: there Fresnel's reflectance is almost 1, as on the rim of the intended smooth surface.
vec3 seen_normal(vec3 n, vec3 facing, vec3 wo, uint kind) {
    float c = dot3(n, wo);
    bool turned = c < SEEN && kind != KIND_BLACK && kind != KIND_DIFFUSE && n != facing;
    vec3 seen = normalize3(n + wo * (SEEN - c));
    return turned ? seen : n;
}

// The direction wi of a lobe, lifted just enough that it leaves the face on the side that wi_z, its cosine to the
// shading normal, indicates. Only a delta lobe's direction can be lifted: other densities would change with it.
//
// wi + (LIFT - wi.g) g, g the face's normal on that side: as if the normal had been turned (Keller et al., The Iray Light
// Transport Simulation and Rendering System, 2017, section 4.3).
vec3 leaving_direction(vec3 n, vec3 facing, vec3 wi, float wi_z, uint lobe) {
    vec3 g = wi_z > 0.0 ? facing : -facing;
    float up = dot3(wi, g);
    bool lifts = up <= 0.0 && lobe >= LOBE_DELTA && n != facing;
    vec3 lifted = normalize3(wi + g * (LIFT - up));
    return lifts ? lifted : wi;
}
