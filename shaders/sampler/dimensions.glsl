// The use of each of a path's random numbers; the same for every scene, kernel and setting.
// Twin of src/reference/sampler/dimensions.rs.
//
//   block           x                     y                        z                w
//   camera_block    pixel column          pixel row                lens u1          lens u2
//   light_block     choice of the light   choice of the primitive  u                v
//   bsdf_block      choice of the lobe    reflect or refract       micro-normal u1  micro-normal u2
//   roulette_block  roulette              diffuse u1               diffuse u2       -
//
// Bounce 0 is at the first surface that the camera sees. A number that a path does not use is skipped, never used for
// something else.
//
// A light path has its own blocks, LIGHT_PATH + the same numbers: camera_block chooses its light (x), the primitive (y)
// and the point (z, w), light_block(0) its direction (x, y). The point of the lens (z, w) that a vertex is joined to
// comes from light_block(bounce + 1), for the light's own point from light_block(0); a bidirectional light path, whose
// own point is not joined, uses that of light_block(0) for its aim (z).

// uses:

// The points of the pixel and the lens through which the camera ray passes.
uint camera_block() {
    return 0u;
}

// The connection to a light.
uint light_block(uint bounce) {
    return 1u + 3u * bounce;
}

// The scattered direction, rough and smooth lobes.
uint bsdf_block(uint bounce) {
    return 2u + 3u * bounce;
}

// Survival, and the diffuse lobe's direction.
uint roulette_block(uint bounce) {
    return 3u + 3u * bounce;
}
