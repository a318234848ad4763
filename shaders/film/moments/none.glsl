// No standard errors are requested.
// uses:

void moments_sample(uint lane, vec3 radiance, uint n) {
}
