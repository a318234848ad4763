// Scrambled Sobol points in four groups: the quarters of the samples are independent pictures, which judge a denoised one.
// Twin of src/reference/sampler/sobol_quarters.rs.

// uses: sampler/sobol_groups

// Four words for one block of a path, pixel = row * width + column of the full picture.
uvec4 sampler_block(uint pixel, uint sample_index, uint block, uint seed) {
    return sobol_block(pixel, sample_index, 2u, block, seed);
}
