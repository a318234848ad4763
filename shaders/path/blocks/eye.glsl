// The random numbers of a path from the eye. Fills the slot <blocks>.

// uses:

// The block of sampler/dimensions itself.
uint path_block(uint block) {
    return block;
}
