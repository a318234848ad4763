// Moves floats from buffer to buffer through a choice, as floats: Vulkan allows a driver to turn any NaN into another
// and a denormal into 0 even where nothing is computed. vkpt stores bit patterns in integers.

// uses: constants/workgroup

layout(local_size_x = WORKGROUP) in;
layout(std430, set = 0, binding = 0) readonly buffer Arguments {
    float values[];
} arguments;
layout(std430, set = 0, binding = 1) buffer Results {
    float values[];
} results;

void main() {
    uint i = gl_GlobalInvocationID.x;
    float a = arguments.values[3u * i];
    float b = arguments.values[3u * i + 1u];
    results.values[i] = (i & 1u) == 0u ? a : b;
}
