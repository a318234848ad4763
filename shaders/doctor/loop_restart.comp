// The lives of loop_one_exit.comp, in a loop without an end condition that is left from inside an if, with a restart
// after it. Mesa 22.3's lavapipe miscompiled such a loop of a path tracer: some lanes lived twice. No loop of vkpt is
// written like this.

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
    while (true) {
        state = state * 747796405u + 2891336453u;
        age += 1u;
        if ((state >> 28u) == 0u) {
            sum = sum * 31u + age;
            lives += 1u;
            if (lives >= 16u) {
                break;
            }
            age = 0u;
            state = pcg4d(uvec4(i, lives, 0u, 0u)).x;
            continue;
        }
        if (age == 40u) {
            sum = sum * 31u + age;
            lives += 1u;
            if (lives >= 16u) {
                break;
            }
            age = 0u;
            state = pcg4d(uvec4(i, lives, 0u, 0u)).x;
        } else {
            sum = sum * 31u + (state >> 30u);
        }
    }
    results.words[i] = sum;
}
