// Shading normals as in the buffers: nine floats a triangle, zeros where its mesh gives none.

vec3 triangle_normal(uint i, uint k) {
    uint at = 9u * i + 3u * k;
    return vec3(normal_words[at], normal_words[at + 1u], normal_words[at + 2u]);
}
