// Scrambled Sobol points: the samples of a pixel are spread evenly, in two groups.
// Twin of src/reference/sampler/sobol.rs.

// uses: sampler/sobol_groups

// Four words for one block of a path, pixel = row * width + column of the full picture.
uvec4 sampler_block(uint pixel, uint sample_index, uint block, uint seed) {
    return sobol_block(pixel, sample_index, 1u, block, seed);
}
