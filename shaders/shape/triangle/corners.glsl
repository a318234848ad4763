// Triangles as the buffers hold them: nine floats each, and their shape.

const uint TRIANGLES = TRIANGLE_SHAPES;

vec3 triangle_vertex(uint i, uint k) {
    uint at = 9u * i + 3u * k;
    return vec3(triangle_words[at], triangle_words[at + 1u], triangle_words[at + 2u]);
}

uint triangle_shape(uint i) {
    return triangle_shapes[i];
}
