// A light picked among many by its importance in the tree.
// Twin of src/reference/integrator/path/pick/tree.rs.
// uses: constants/material_kind, sampler/unit_float, light/tree/descent, light/tree/tickets, integrator/path/pick/candidate

// The normal on whose side a vertex can be lit; 0 if light may come from both.
vec3 lit_side(Vertex v) {
    return v.interaction.material.kind < KIND_ROUGH_DIELECTRIC ? v.facing : vec3(0.0);
}

// The light that the tree picks, and a point of it.
Candidate pick_in_tree(Subpath path, Vertex v, uvec4 u) {
    TreeChoice choice = tree_choice(v.p, lit_side(v), all_tickets(u));
    Candidate c = no_candidate();
    if (choice.pmf > 0.0) {
        c = candidate(path, v, choice.light, choice.pmf, u.y >> 8u, vec2(unit_float(u.z), unit_float(u.w)));
    }
    return c;
}
