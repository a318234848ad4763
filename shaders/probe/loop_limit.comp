// Counts to `goal` in a loop whose length the compiler cannot know. A driver that ends loops early, in silence
// (Mesa 22's lavapipe after 65,535 iterations a subgroup and dispatch), leaves a smaller count.
// uses:

layout(local_size_x = 1) in;
layout(std430, set = 0, binding = 0) buffer Words { uint goal; uint count; } words;

void main() {
    uint goal = words.goal;
    uint x = 1u;
    uint i = 0u;
    while (i < goal && x != 0u) {
        x = x * 1664525u + 1013904223u | 1u;
        i += 1u;
    }
    words.count = i;
}
