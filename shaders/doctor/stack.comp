// A stack in a private array without an initial value, pushed and popped at indices that differ between lanes: the
// traversal of a hierarchy. naga zeroes such arrays at each call; vkpt strips that from the SPIR-V.

// uses: constants/workgroup, sampler/pcg4d

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    uint stack[24];
    stack[0] = i;
    uint top = 1u;
    uint sum = 0u;
    uint visits = 0u;
    while (top > 0u && visits < 200u) {
        visits += 1u;
        top -= 1u;
        uint node = stack[top];
        sum = sum * 31u + node;
        uint children = pcg4d(uvec4(node, visits, 0u, 0u)).x >> 30u;
        uint child = 0u;
        while (child < children && top < 24u) {
            stack[top] = node * 4u + child + 1u;
            top += 1u;
            child += 1u;
        }
    }
    results.words[i] = sum;
}
