//! Pictures given by formulas.

use vkpt::film::Film;

/// The picture of `pixel(x, y)`.
pub fn film(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [f32; 3]) -> Film {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Film {
        width,
        height,
        rgb: places.map(|(x, y)| pixel(x, y)).collect(),
    }
}

pub fn constant(width: u32, height: u32, rgb: [f32; 3]) -> Film {
    film(width, height, |_, _| rgb)
}

/// Each value of `a` through `f`.
pub fn mapped(a: &Film, f: impl Fn(f32) -> f32) -> Film {
    film(a.width, a.height, |x, y| at(a, x, y).map(&f))
}

pub fn at(film: &Film, x: u32, y: u32) -> [f32; 3] {
    film.rgb[(y * film.width + x) as usize]
}

/// Seeded random numbers: SplitMix64 (Steele, Lea and Flood 2014).
pub struct Random(pub u64);

impl Random {
    /// In [0, 1).
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Of mean 0 and standard deviation 1 (Box and Muller 1958).
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }

    /// The picture with noise of these standard errors.
    pub fn noisy(&mut self, mean: &Film, stderr: &Film) -> Film {
        let noisy = |(m, s): (f32, f32)| (f64::from(m) + f64::from(s) * self.normal()) as f32;
        let values = mean.rgb.iter().flatten().zip(stderr.rgb.iter().flatten());
        let values: Vec<f32> = values.map(|(&m, &s)| (m, s)).map(noisy).collect();
        Film {
            rgb: values.as_chunks().0.to_vec(),
            ..*mean
        }
    }
}
