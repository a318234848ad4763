// Owen-scrambled Sobol points, four dimensions at a time, in groups of samples that are independent of one another.
// Twin of src/reference/sampler/sobol_groups.rs.
// uses: sampler/pcg4d, sampler/owen, sampler/sobol_digits

// Wellons, Prospecting for Hash Functions, 2018: lowbias32.
uint lowbias32(uint x) {
    uint a = (x ^ (x >> 16u)) * 0x7feb352du;
    uint b = (a ^ (a >> 15u)) * 0x846ca68bu;
    return b ^ (b >> 16u);
}

// Four words for one block of a path, pixel = row * width + column of the full picture. Samples whose indices agree in their
// last group_bits binary digits are a group.
// Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020: the index is shuffled, the coordinates are scrambled,
// separately for each block of each group of samples. The words most used as pairs have the dimensions that pair best.
uvec4 sobol_block(uint pixel, uint sample_index, uint group_bits, uint block, uint seed) {
    // The same for all of a thread's samples: compilers move it out of the loop.
    uvec4 key = pcg4d(uvec4(pixel, 0u, 0u, seed));
    uint group = sample_index & ((1u << group_bits) - 1u);
    uint shuffle = lowbias32(key.x + (block << group_bits) + group);
    uvec4 product = (key ^ shuffle) * 0x9e3779b1u;
    uvec4 scramble = product ^ (product >> 16u);
    uint index = bitfieldReverse(owen_scramble(bitfieldReverse(sample_index >> group_bits), shuffle));
    return uvec4(bitfieldReverse(owen_scramble(sobol_digits_3(index), scramble.x)),
                 bitfieldReverse(owen_scramble(sobol_digits_1(index), scramble.y)),
                 bitfieldReverse(owen_scramble(index, scramble.z)),
                 bitfieldReverse(owen_scramble(sobol_digits_2(index), scramble.w)));
}
