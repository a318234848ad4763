//! The pixel's filter: a box one pixel wide. Every path starts within its pixel, uniformly.

use super::{ALPHA, story, world};
use crate::common::settings::independent;
use crate::common::stats::{chi_square, sidak};

const SIZE: [u32; 2] = [40, 30];
/// tan of half the vertical field of view.
const RY: f64 = 0.6;
const SAMPLES: u32 = 20_000;
/// Along each side of the pixel.
const CELLS: usize = 12;

/// Where in its pixel the camera's ray went through, each coordinate in [0, 1), from its direction alone.
fn places(pixel: [u32; 2]) -> impl Iterator<Item = [f64; 2]> {
    let settings = independent();
    let text = format!(
        "screen {} {}\ncamera 0 0 0 {RY}\nbackground 1 1 1\nlight 1 1 1\nsphere 0 0 100 1\n",
        SIZE[0], SIZE[1]
    );
    let world = world(&text, &settings);
    let size = SIZE.map(f64::from);
    (0..SAMPLES).map(move |sample| {
        let d = story(&world, &settings, pixel, sample).escaped;
        let d = d.expect("the camera looks away from the light");
        // the picture plane one unit away: x to the right, y up, rows from the top
        let x = d.x / -d.z / (RY * size[0] / size[1]);
        let y = d.y / -d.z / RY;
        let column = 0.5 * (x + 1.0) * size[0] - f64::from(pixel[0]);
        let row = 0.5 * (1.0 - y) * size[1] - f64::from(pixel[1]);
        [column, row]
    })
}

/// p-value of the places' being uniform, the first coordinate bent to x^`bend` before.
fn p_value(pixel: [u32; 2], bend: f64) -> f64 {
    let mut counts = vec![0; CELLS * CELLS];
    for [x, y] in places(pixel) {
        assert!((-1e-9..1.0 + 1e-9).contains(&x) && (-1e-9..1.0 + 1e-9).contains(&y));
        let cell = |x: f64| ((x.max(0.0) * CELLS as f64) as usize).min(CELLS - 1);
        counts[cell(x.abs().powf(bend)) * CELLS + cell(y)] += 1;
    }
    let expected = f64::from(SAMPLES) / (CELLS * CELLS) as f64;
    chi_square(&counts, &vec![expected; CELLS * CELLS])
}

#[test]
fn paths_start_all_over_their_pixel() {
    let pixels = [[0, 0], [39, 0], [17, 12], [0, 29], [39, 29]];
    let level = sidak(ALPHA, pixels.len());
    for pixel in pixels {
        let p = p_value(pixel, 1.0);
        assert!(p > level, "pixel {pixel:?}: p = {p:e}");
        assert!(p_value(pixel, 1.1) < level, "x^1.1 passes");
    }
}
