// Each invocation runs once: each changes its own word, in a way that a second run would not undo.

// uses: constants/workgroup

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    results.words[i] = results.words[i] * 31u + i;
}
