// Random lives, one after the other, in a loop with one exit at its head: the form of every loop of vkpt. Lanes begin
// their next life at different steps.

// uses: constants/workgroup, sampler/pcg4d

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    uint lives = 0u;
    uint age = 0u;
    uint sum = 0u;
    uint state = pcg4d(uvec4(i, 0u, 0u, 0u)).x;
    while (lives < 16u) {
        state = state * 747796405u + 2891336453u;
        age += 1u;
        bool dies = (state >> 28u) == 0u || age == 40u;
        sum = sum * 31u + (dies ? age : state >> 30u);
        if (dies) {
            lives += 1u;
            age = 0u;
            state = pcg4d(uvec4(i, lives, 0u, 0u)).x;
        }
    }
    results.words[i] = sum;
}
