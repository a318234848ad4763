//! A hash of four words to four words.

/// Hash of four words to four words.
///
/// Jarzynski & Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020:
/// a linear congruential step a component, then two rounds that mix the components, with a shift of the
/// upper half into the lower between them.
pub fn pcg4d(v: [u32; 4]) -> [u32; 4] {
    let v = v.map(|x| x.wrapping_mul(1664525).wrapping_add(1013904223));
    mix_words(mix_words(v).map(|x| x ^ (x >> 16)))
}

/// x += y w, y += z x, z += x y, w += y z, one after the other.
pub fn mix_words(v: [u32; 4]) -> [u32; 4] {
    let [x, y, z, w] = v;
    let x = x.wrapping_add(y.wrapping_mul(w));
    let y = y.wrapping_add(z.wrapping_mul(x));
    let z = z.wrapping_add(x.wrapping_mul(y));
    let w = w.wrapping_add(y.wrapping_mul(z));
    [x, y, z, w]
}
