//! Seeded inputs.

use vkpt::reference::math::{Vec3, vec3};

/// splitmix64, so that rows stay the same for ever.
pub struct Rng(u64);

impl Rng {
    /// The same sequence for the same name.
    pub fn named(name: &str) -> Self {
        // FNV-1a
        Self(name.bytes().fold(0xcbf2_9ce4_8422_2325, |h, b| {
            (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3)
        }))
    }
    pub fn u32(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) >> 32) as u32
    }
    /// In [0, 1), a multiple of 2⁻²⁴, as the sampler's.
    pub fn unit(&mut self) -> f32 {
        (self.u32() >> 8) as f32 / 16_777_216.0
    }
    pub fn range(&mut self, lo: f32, hi: f32) -> f32 {
        lo + (hi - lo) * self.unit()
    }
    /// Uniform in the logarithm; 0 < lo < hi.
    pub fn log_range(&mut self, lo: f32, hi: f32) -> f32 {
        lo * (hi / lo).powf(self.unit())
    }
    /// Below `n`.
    pub fn below(&mut self, n: u32) -> u32 {
        self.u32() % n
    }
    pub fn bool(&mut self) -> bool {
        self.u32() & 1 == 1
    }
    /// Any finite number, all exponents alike.
    pub fn finite(&mut self) -> f32 {
        loop {
            let x = f32::from_bits(self.u32());
            if x.is_finite() {
                return x;
            }
        }
    }
    /// A unit vector, uniform over the sphere.
    pub fn direction(&mut self) -> Vec3<f32> {
        let z = f64::from(self.range(-1.0, 1.0));
        let phi = f64::from(self.unit()) * std::f64::consts::TAU;
        let r = (1.0 - z * z).max(0.0).sqrt();
        vec3((r * phi.cos()) as f32, (r * phi.sin()) as f32, z as f32)
    }
    /// A unit vector with z > 0.
    pub fn hemisphere(&mut self) -> Vec3<f32> {
        loop {
            let v = self.direction();
            if v.z != 0.0 {
                return vec3(v.x, v.y, v.z.abs());
            }
        }
    }
    /// All components in [lo, hi).
    pub fn vec3(&mut self, lo: f32, hi: f32) -> Vec3<f32> {
        vec3(self.range(lo, hi), self.range(lo, hi), self.range(lo, hi))
    }
}
