//! Seeded random numbers for scenes and rays.

use glam::DVec3;

/// PCG32 (O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for Random Number
/// Generation, 2014).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_add(0x853c_49e6_748f_ea9b));
        random.bits();
        random
    }

    pub fn bits(&mut self) -> u32 {
        let s = self.0;
        self.0 = s
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((((s >> 18) ^ s) >> 27) as u32).rotate_right((s >> 59) as u32)
    }

    /// An integer below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        ((u64::from(self.bits()) * n as u64) >> 32) as usize
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        f64::from(self.bits()) * 2f64.powi(-32)
    }

    /// Uniform in [−1, 1)³.
    pub fn in_cube(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }

    /// Uniform on the unit sphere.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.in_cube();
            let length = v.length();
            if (1e-3..=1.0).contains(&length) {
                return v / length;
            }
        }
    }
}
