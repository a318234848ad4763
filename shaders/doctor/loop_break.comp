// Loops in a loop, left by lanes at different steps: Collatz's sequence from i + 1 to i + 8, abandoned at a number that
// ends in 37 of 64. Lanes that have left must not count on.

// uses: constants/workgroup

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    uint sum = 0u;
    uint start = 1u;
    while (start <= 8u) {
        uint n = i + start;
        uint steps = 0u;
        while (n > 1u) {
            if ((n & 63u) == 37u) {
                break;
            }
            n = (n & 1u) == 0u ? n >> 1u : 3u * n + 1u;
            steps += 1u;
        }
        sum = sum * 31u + steps;
        start += 1u;
    }
    results.words[i] = sum;
}
