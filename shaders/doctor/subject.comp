// Calls one function or operation on a table of arguments, three words in and one out; the host compares the
// results with its own, bit by bit or in f64. Errors seen: sums of products contracted or rewritten wherever
// NoContraction is missing (Mesa 22 and 25); GLSL's own log 3100 units of the last place off near 1 (lavapipe),
// sin 1.9e-4 (SwiftShader).

// uses: constants/workgroup, <subject>

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 0) readonly buffer Arguments {
    uint words[];
} arguments;
layout(std430, set = 0, binding = 1) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    uvec3 w = uvec3(arguments.words[3u * i], arguments.words[3u * i + 1u], arguments.words[3u * i + 2u]);
    results.words[i] = subject(w);
}
