// A path from a light meets shading normals. Fills the slot <correction>.

// uses: path/correction/adjoint

vec3 corrected(Vertex v, vec3 wi, vec3 wi_local, vec3 value) {
    return adjoint_value(v, wi, wi_local, value);
}
