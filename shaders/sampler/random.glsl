// Independent random numbers: a hash of where they are used.
// Twin of src/reference/sampler/random.rs.

// uses: sampler/pcg4d

// Four words for one block of a path, pixel = row * width + column of the full picture.
uvec4 sampler_block(uint pixel, uint sample_index, uint block, uint seed) {
    return pcg4d(uvec4(pixel, sample_index, block, seed));
}
