//! Seeded random numbers in f64.

use vkpt::reference::bsdf::BsdfRandom;

/// splitmix64 (Steele, Lea & Flood 2014).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0xd134_2543_de82_ef95))
    }
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }
    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn pair(&mut self) -> [f64; 2] {
        [self.unit(), self.unit()]
    }
}

/// The numbers that a sample of a BSDF draws from.
pub fn random<F>(lobe: F, reflect: F, m: [F; 2], d: [F; 2]) -> BsdfRandom<F> {
    BsdfRandom {
        lobe,
        reflect,
        m,
        d,
    }
}
