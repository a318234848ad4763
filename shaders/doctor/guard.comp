// Code behind a condition runs where it is true, and nowhere else: nested ifs guard an index, `?:` calls one side.
// Compilers that flatten branches must keep the two sides apart. (naga evaluates both sides of `&&` and `||`, on every
// device alike: no kernel guards anything with those.)

// uses: constants/workgroup, sampler/pcg4d

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 1) readonly buffer Given {
    uint words[];
} given;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

uint calls = 0u;

uint called(uint place, uint value) {
    calls += place;
    return value;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    uvec4 r = pcg4d(uvec4(i, 1u, 0u, 0u));
    // Half of the indices are far beyond the end.
    uint at = (r.x & 1u) == 0u ? i : 0x3fffffffu - i;
    uint found = 7u;
    if (at <= i) {
        if (given.words[at] == i) {
            found = called(1u, 11u);
        }
    }
    uint chosen = (r.y & 2u) == 0u ? called(256u, r.z) : called(65536u, r.w);
    results.words[i] = (found * 31u + chosen) ^ calls;
}
