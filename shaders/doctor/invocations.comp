// Each invocation runs once: every word is changed by its own, in a way that a second time would not undo.

// uses:

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    results.words[i] = results.words[i] * 31u + i;
}
