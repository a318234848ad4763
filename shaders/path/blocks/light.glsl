// The random numbers of a path from a light: its own, never shared with the eye path of the same pixel and sample.
// Fills the slot <blocks>.

// uses: constants/path, sampler/dimensions

// The block of sampler/dimensions, among those of light paths.
uint path_block(uint block) {
    return LIGHT_PATH + block;
}
