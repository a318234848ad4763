// Counts to `goal` in a loop that no compiler can shorten: its body is a random number generator, whose state is also
// an output. A driver that ends loops early and silently (Mesa 22's lavapipe, after 65,535 iterations a subgroup and
// dispatch) leaves a smaller count.
// uses:

layout(local_size_x = 1) in;
layout(std430, set = 0, binding = 0) buffer Words {
    uint goal;
    uint count;
    uint state;
} words;

void main() {
    uint goal = words.goal;
    uint state = goal;
    uint count = 0u;
    while (count < goal) {
        state = (state ^ (state >> 15)) * 1664525u + 1013904223u;
        count += 1u;
    }
    words.count = count;
    words.state = state;
}
