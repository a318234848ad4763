// Calls the subject 64 times an invocation on numbers in [0, 1), to time a call.

// uses: constants/workgroup, <subject>

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 0) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    uint state = i * 747796405u + 2891336453u;
    uint sum = 0u;
    uint calls = 0u;
    while (calls < 64u) {
        state = state * 747796405u + 2891336453u;
        // a number in [1, 2), less 1
        uint x = floatBitsToUint(uintBitsToFloat(0x3f800000u | (state >> 9u)) - 1.0);
        sum ^= subject(uvec3(x, x, x));
        calls += 1u;
    }
    results.words[i] = sum;
}
