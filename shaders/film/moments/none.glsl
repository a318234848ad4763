// Nobody asks for standard errors.
// uses:

void moments_sample(uint lane, vec3 radiance, uint n) {
}
