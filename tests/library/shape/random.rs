//! Seeded numbers for tests: SplitMix64 (Steele, Lea, Flood 2014).

use vkpt::reference::math::{Real, Vec3, vec3};

pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1), a multiple of 2⁻²⁴ as the sampler's numbers are.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 40) as f64 / 16_777_216.0
    }

    pub fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    /// Uniform on the unit sphere, rounded to `F` as a renderer would: unit to an ulp or two.
    pub fn direction<F: Real>(&mut self) -> Vec3<F> {
        let z = self.between(-1.0, 1.0);
        let (sin, cos) = (self.unit() * std::f64::consts::TAU).sin_cos();
        let r = (1.0 - z * z).sqrt();
        vec3(F::new(r * cos), F::new(r * sin), F::new(z))
    }

    /// Uniform in the cube of half-width `size`.
    pub fn point<F: Real>(&mut self, size: f64) -> Vec3<F> {
        let mut c = || F::new(self.between(-size, size));
        vec3(c(), c(), c())
    }
}
