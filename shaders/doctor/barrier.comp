// A sum over a workgroup in shared memory, by halves, with a barrier after each; lanes arrive after loops of different
// lengths. Drivers have let lanes of other subgroups read before the barrier. No kernel of vkpt's shares memory.

// uses: constants/workgroup, sampler/pcg4d

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

shared uint sums[WORKGROUP];

void main() {
    uint i = gl_GlobalInvocationID.x;
    uint lane = gl_LocalInvocationID.x;
    uint word = i;
    uint steps = pcg4d(uvec4(i, 5u, 0u, 0u)).x >> 27u;
    while (steps > 0u) {
        word = word * 747796405u + 2891336453u;
        steps -= 1u;
    }
    sums[lane] = word;
    barrier();
    uint half_of = WORKGROUP / 2u;
    while (half_of > 0u) {
        if (lane < half_of) {
            sums[lane] += sums[lane + half_of];
        }
        barrier();
        half_of >>= 1u;
    }
    results.words[i] = sums[0] + lane;
}
