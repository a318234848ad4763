// An array in a uniform buffer, read at an index of each lane's own: materials, lights and shapes of a scene. Hardware
// whose constant reads are meant to be the same for all lanes serves them one after the other.

// uses: constants/workgroup, sampler/pcg4d

layout(local_size_x = WORKGROUP) in;
layout(std140, set = 0, binding = 0) uniform Table {
    uvec4 rows[1024];
} table;
layout(std430, set = 0, binding = 2) buffer Results {
    uint words[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    uvec4 at = pcg4d(uvec4(i, 2u, 0u, 0u)) >> 22u;
    results.words[i] = table.rows[at.x].x + 3u * table.rows[at.y].y + 5u * table.rows[at.z].z + 7u * table.rows[at.w].w;
}
