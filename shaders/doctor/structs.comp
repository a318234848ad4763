// Structs within structs, copied whole, chosen, and changed by functions that take them inout: a copy must not change.
// Drivers split such structs into scalars, and naga's copies with them.

// uses: constants/workgroup, sampler/pcg4d

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

struct Medium {
    uvec3 sigma;
    uint index;
};

struct Path {
    Medium inside;
    Medium outside;
    uint length;
};

void cross_surface(inout Path path, uint by) {
    Medium kept = path.inside;
    path.inside = path.outside;
    path.outside = kept;
    path.outside.index += by;
    path.length += 1u;
}

uint digest(Path p) {
    uint inside = p.inside.sigma.x + 3u * p.inside.sigma.y + 5u * p.inside.sigma.z + 7u * p.inside.index;
    uint outside = p.outside.sigma.x + 3u * p.outside.sigma.y + 5u * p.outside.sigma.z + 7u * p.outside.index;
    return (inside * 31u + outside) * 31u + p.length;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    uvec4 a = pcg4d(uvec4(i, 3u, 0u, 0u));
    uvec4 b = pcg4d(uvec4(i, 3u, 1u, 0u));
    Path path = Path(Medium(a.xyz, a.w), Medium(b.xyz, b.w), 0u);
    Path before = path;
    uint turn = 0u;
    while (turn < 1u + (i & 3u)) {
        cross_surface(path, turn);
        turn += 1u;
    }
    uint sum = digest(path) * 31u + digest(before);
    before = (i & 1u) == 0u ? path : before;
    results.words[i] = sum * 31u + digest(before);
}
