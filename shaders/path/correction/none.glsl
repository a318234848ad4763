// A path from the eye, or flat surfaces: nothing to correct. Fills the slot <correction>.

// uses: path/vertex

vec3 corrected(Vertex v, vec3 wi, vec3 wi_local, vec3 value) {
    return value;
}
