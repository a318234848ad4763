// One of several dispatches, each of which reads words that other lanes of the last one wrote: unfinished paths are
// passed on in this way. Without a barrier between them, caches may hold older words.

// uses: constants/workgroup, sampler/pcg4d

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Given {
    uint words[];
} given;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    uint from = pcg4d(uvec4(i, 4u, 0u, 0u)).x & 0xffffu;
    results.words[i] = given.words[from] * 31u + i;
}
