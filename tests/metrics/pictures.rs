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
