// Shading normals, met by paths from both ends. Fills the slot <correction>.

// uses: path/origin, path/correction/adjoint

vec3 corrected(Vertex v, vec3 wi, vec3 wi_local, vec3 value) {
    vec3 adjoint = adjoint_value(v, wi, wi_local, value);
    return from_light ? adjoint : value;
}
