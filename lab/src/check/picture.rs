//! A case's pictures: the mean of each pixel's samples, by the device and by cpu-f64.

use vkpt::film::Film;
use vkpt::metrics::{difference_map, signed_difference};
use vkpt::sample::PairedSample;

/// The pixels of a rectangle.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    origin: [u32; 2],
    width: u32,
    height: u32,
    pixels: Vec<Pixel>,
}

/// Sums over the samples that are finite on both sides: the film drops others.
#[derive(Clone, Copy, Debug, Default)]
struct Pixel {
    device: [f64; 3],
    f64: [f64; 3],
    finite: u32,
    /// Whether some are not finite.
    broken: bool,
}

impl Picture {
    /// Without samples yet; left, top, right, bottom as of a crop.
    pub fn new([left, top, right, bottom]: [u32; 4]) -> Self {
        let (width, height) = (right - left, bottom - top);
        Self {
            origin: [left, top],
            width,
            height,
            pixels: vec![Pixel::default(); width as usize * height as usize],
        }
    }

    /// Adds a sample if it belongs to one of its pixels.
    pub fn add(&mut self, sample: &PairedSample) {
        let [x, y] = [0, 1].map(|i| sample.address.pixel[i].checked_sub(self.origin[i]));
        let (Some(x), Some(y)) = (x.filter(|x| *x < self.width), y) else {
            return;
        };
        let place = y as usize * self.width as usize + x as usize;
        if let Some(pixel) = self.pixels.get_mut(place) {
            pixel.add(sample.device.radiance, sample.f64.radiance);
        }
    }

    /// The mean of each pixel by the device.
    pub fn device(&self) -> Film {
        self.film(|pixel| pixel.mean(pixel.device))
    }

    /// The mean of each pixel by cpu-f64.
    pub fn reference(&self) -> Film {
        self.film(|pixel| pixel.mean(pixel.f64))
    }

    /// Where they differ, as [`difference_map`] shows it: from the means in f64, which resolve less than an ulp of f32. Black
    /// where a sample was not finite.
    pub fn difference(&self) -> Film {
        let differences: Vec<f64> = self.pixels.iter().map(Pixel::difference).collect();
        difference_map(self.width, self.height, &differences)
    }

    fn film(&self, mean: impl Fn(&Pixel) -> [f64; 3]) -> Film {
        let rgb = self.pixels.iter().map(|p| mean(p).map(|x| x as f32));
        Film {
            width: self.width,
            height: self.height,
            rgb: rgb.collect(),
        }
    }
}

impl Pixel {
    fn add(&mut self, device: [f64; 3], f64: [f64; 3]) {
        if device.iter().chain(&f64).any(|x| !x.is_finite()) {
            self.broken = true;
            return;
        }
        self.finite += 1;
        for c in 0..3 {
            self.device[c] += device[c];
            self.f64[c] += f64[c];
        }
    }

    fn mean(&self, sum: [f64; 3]) -> [f64; 3] {
        sum.map(|x| x / f64::from(self.finite.max(1)))
    }

    fn difference(&self) -> f64 {
        match self.broken {
            true => f64::NAN,
            false => signed_difference(self.mean(self.device), self.mean(self.f64)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vkpt::sample::{Address, Path};

    /// A picture of 4 × 3 pixels at (10, 20) of two samples each; `device` changes the device's radiance.
    fn picture(device: impl Fn(Address) -> f64) -> Picture {
        let mut picture = Picture::new([10, 20, 14, 23]);
        for k in 0..24 {
            let pixel = [10 + k / 2 % 4, 20 + k / 8];
            let address = Address {
                pixel,
                index: k % 2,
            };
            let path = |x: f64| Path {
                radiance: [x, 0.5 * x, 0.0],
                signature: 0,
            };
            let honest = f64::from(1 + k);
            picture.add(&PairedSample {
                address,
                device: path(honest * device(address)),
                f32: path(honest),
                f64: path(honest),
            });
        }
        picture
    }

    /// The colour of a difference, as a film has it.
    fn colour(difference: f64) -> [f32; 3] {
        difference_map(1, 1, &[difference]).rgb[0]
    }

    #[test]
    fn pixels_have_the_means_of_their_samples() {
        let picture = picture(|_| 1.0);
        // Samples 2k + 1 and 2k + 2.
        for (k, pixel) in picture.device().rgb.iter().enumerate() {
            let mean = 2.0 * k as f32 + 1.5;
            assert_eq!(*pixel, [mean, 0.5 * mean, 0.0]);
        }
        assert_eq!(picture.device(), picture.reference());
        assert_eq!(picture.difference().rgb, [colour(0.0); 12]);
    }

    /// Planted in one sample of one pixel: an ulp of f32, a sample that went elsewhere, a NaN.
    #[test]
    fn a_planted_difference_is_seen_where_it_is_and_nowhere_else() {
        let planted = |address: Address| address.pixel == [12, 21] && address.index == 1;
        for (factor, brighter) in [(1.0 + 2f64.powi(-22), 1.0), (0.25, -1.0), (f64::NAN, 0.0)] {
            let picture = picture(|a| if planted(a) { factor } else { 1.0 });
            let mut colours = picture.difference().rgb;
            // Row 1, column 2 of 4; its samples are 13 and 14.
            let [red, green, blue] = colours.remove(4 + 2);
            assert_eq!(colours, [colour(0.0); 11]);
            let expected = match factor.is_nan() {
                true => f64::NAN,
                false => signed_difference([13.0 + 14.0 * factor; 3], [27.0; 3]),
            };
            assert_eq!([red, green, blue], colour(expected));
            assert_eq!(red > blue, brighter > 0.0, "{red}, {blue}");
            assert_eq!(red < blue, brighter < 0.0, "{red}, {blue}");
            // Samples that are not finite are dropped on both sides.
            assert_eq!(
                picture.reference().rgb[6][0],
                if factor.is_nan() { 13.0 } else { 13.5 }
            );
        }
    }
}
