// The adjoint of a BSDF with shading normals.

// uses: math/vec, path/vertex

// value |wo.Ns||wi.Ng|/(|wo.Ng||wi.Ns|): the BSDF of shading normals is not symmetric (Veach, Robust Monte Carlo
// Methods for Light Transport Simulation, 1997, eq. 5.19). `value` has the cosine |wi.Ns| already. 0 where wo's sides
// differ, as on eye paths; value itself where the two normals are equal.
vec3 adjoint_value(Vertex v, vec3 wi, vec3 wi_local, vec3 value) {
    vec3 apart = v.frame.n - v.facing;
    bool one = apart.x == 0.0 && apart.y == 0.0 && apart.z == 0.0;
    vec3 wo = v.interaction.wo;
    float wo_ng = dot3(to_world(v.frame, wo), v.facing);
    float factor = wo.z * abs(dot3(wi, v.facing)) / (wo_ng * abs(wi_local.z));
    bool valid = wo.z > 0.0 && wo_ng > 0.0;
    return one ? value : (valid ? value * factor : vec3(0.0));
}
