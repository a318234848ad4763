// A hash of four words to four words.
// Twin of src/reference/sampler/pcg4d.rs.

// uses:

// x += y w, y += z x, z += x y, w += y z, one after the other.
uvec4 mix_words(uvec4 v) {
    uint x = v.x + v.y * v.w;
    uint y = v.y + v.z * x;
    uint z = v.z + x * y;
    uint w = v.w + y * z;
    return uvec4(x, y, z, w);
}

// A linear congruential step a component, then two rounds that mix the components, with a shift of the upper half
// into the lower between them. Jarzynski & Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020.
uvec4 pcg4d(uvec4 v) {
    uvec4 a = mix_words(v * 1664525u + 1013904223u);
    return mix_words(a ^ (a >> 16u));
}
