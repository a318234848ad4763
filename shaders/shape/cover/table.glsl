// Coincident faces: which of them counts (model.md, "Coincident faces"). Fills the slot <cover>.
// Twin of src/reference/shape/cover.rs. The lists are those of src/shape/coincident.rs.
// uses: constants/none, constants/ray, math/steps, shape/ray, <face_point>

// Where the list of a face begins in `coincidences`, and where it ends.
uvec2 coincidences_of(uint shape, uint prim) {
    uint face = coincident_faces[shape] + prim;
    return uvec2(coincident_faces[face], coincident_faces[face + 1u]);
}

// Whether a hit of `ray` with this face does not count: the ray starts on a face that coincides with it, or another
// comes first at this point. Among touching solids, the one that contains the ray comes first: it `enters` the other
// from air alone. Unless `asked`, the hit counts; an `if` around the loop crashes Mesa 22.3's compiler.
bool is_covered(bool asked, Ray ray, uint shape, uint prim, float t, bool enters) {
    uvec2 list = coincidences_of(shape, prim);
    list.y = asked ? list.y : list.x;
    vec3 p = ray.o + ray.d * t;
    bool covered = false;
    while (list.x < list.y) {
        loop_steps += 1u;
        Coincidence c = coincidences[list.x];
        bool starts = c.shape == ray.shape && c.prim == ray.prim;
        bool first = c.touches == 0u || (enters && ray.medium != NONE);
        bool there = face_point(c, p).within;
        covered = covered || starts || (first && there);
        list.x += 1u;
    }
    return covered;
}

// Whether a face that comes first covers this one at the point p.
bool is_covered_at(uint shape, uint prim, vec3 p) {
    // The background, which is no shape, has no faces: any list will do, because none of it is read.
    bool is_shape = shape != NONE;
    uvec2 list = coincidences_of(is_shape ? shape : 0u, is_shape ? prim : 0u);
    list.y = is_shape ? list.y : list.x;
    bool covered = false;
    while (list.x < list.y) {
        loop_steps += 1u;
        Coincidence c = coincidences[list.x];
        bool there = face_point(c, p).within;
        covered = covered || (c.touches == 0u && there);
        list.x += 1u;
    }
    return covered;
}

// The hit of a ray that has left a solid where another touches it: with that one, at once. Elsewhere `best`.
Hit touching(Ray ray, Hit best) {
    bool leaves = ray.start == START_OUTSIDE && ray.shape != NONE && ray.medium == NONE;
    uvec2 list = coincidences_of(leaves ? ray.shape : 0u, leaves ? ray.prim : 0u);
    list.y = leaves ? list.y : list.x;
    Hit met = best;
    bool found = false;
    while (list.x < list.y) {
        loop_steps += 1u;
        Coincidence c = coincidences[list.x];
        FacePoint at = face_point(c, ray.o);
        if (!found && c.touches != 0u && at.within) {
            met = Hit(0.0, c.shape, c.prim, at.uv);
            found = true;
        }
        list.x += 1u;
    }
    return met;
}
