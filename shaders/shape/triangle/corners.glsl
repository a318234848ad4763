// Triangles from the buffers, nine floats each, and their shapes.

struct Triangle {
    vec3 v0;
    vec3 v1;
    vec3 v2;
    uint shape;
};

vec3 triangle_vertex(uint i, uint k) {
    uint at = 9u * i + 3u * k;
    return vec3(triangle_words[at], triangle_words[at + 1u], triangle_words[at + 2u]);
}

Triangle triangle_at(uint i) {
    return Triangle(triangle_vertex(i, 0u), triangle_vertex(i, 1u), triangle_vertex(i, 2u), triangle_shapes[i]);
}
