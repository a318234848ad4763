//! A floor out of focus, lit by a ball: its radiance by Lambert's formula, its picture by quadrature in f64.

use vkpt::settings::Integrator;

use super::pictures::{ALPHA, INTEGRATORS, pictures};
use crate::common::stats::{p_of_mean, sidak};
use crate::light_tracing::{FLOOR, floor_radiance};

/// A floor through a lens: the mean of floor_radiance over the lens and a pixel. The eye is 4 above it; the picture's point x
/// at distance 1 shows, through the lens's point l, the floor at F x + (l − F x)(1 − 4/F).
struct Floor {
    radius: f64,
    focus: f64,
}

impl Floor {
    fn text(&self) -> String {
        format!("{FLOOR}lens {} {}\n", self.radius, self.focus)
    }

    /// Over each 4 × 4 block of pixels, by 24 × 24 points of it and 48 × 96 of the lens, which leaves 4e-5: half as many each
    /// way are off by 1.4e-4.
    fn blocks(&self) -> Vec<f64> {
        const RINGS: usize = 48;
        let side = |k: f64| 0.5 * (2.0 * k / 16.0 - 1.0);
        let floor = |x: f64, l: f64| l * (1.0 - 4.0 / self.focus) + 4.0 * x;
        let lens: Vec<[f64; 2]> = (0..2 * RINGS * RINGS)
            .map(|j| {
                let r = self.radius * (((j % RINGS) as f64 + 0.5) / RINGS as f64).sqrt();
                let (sin, cos) =
                    (std::f64::consts::PI * (j / RINGS) as f64 / RINGS as f64).sin_cos();
                [r * cos, r * sin]
            })
            .collect();
        let block = |i: usize| {
            let (column, row) = ((i % 4 * 4) as f64, (i / 4 * 4) as f64);
            let at = |k: usize| {
                let (a, b) = ((k % 24) as f64 + 0.5, (k / 24) as f64 + 0.5);
                let (x, y) = (side(column + a / 6.0), -side(row + b / 6.0));
                let of = |l: &[f64; 2]| floor_radiance(floor(x, l[0]), floor(y, l[1]));
                lens.iter().map(of).sum::<f64>() / lens.len() as f64
            };
            (0..576).map(at).sum::<f64>() / 576.0
        };
        (0..16).map(block).collect()
    }

    fn p(&self, expected: &[f64], integrator: Integrator) -> f64 {
        let mut blocks = vec![Vec::new(); 16];
        for film in pictures(&self.text(), integrator, 512, 24) {
            let mut sums = [0.0; 16];
            for (i, rgb) in film.rgb.iter().enumerate() {
                sums[i / 64 * 4 + i % 16 / 4] += f64::from(rgb[0]) / 16.0;
            }
            blocks
                .iter_mut()
                .zip(sums)
                .for_each(|(all, sum)| all.push(sum));
        }
        let p = blocks.iter().zip(expected);
        p.map(|(samples, e)| p_of_mean(samples, *e, 0.0))
            .fold(1.0, f64::min)
    }
}

#[test]
fn a_floor_out_of_focus_is_as_bright_as_quadrature_says() {
    let level = sidak(ALPHA, 16 * 3 * 2);
    for floor in [
        Floor {
            radius: 1.4,
            focus: 2.0,
        },
        Floor {
            radius: 1.4,
            focus: 1e6,
        },
    ] {
        let expected = floor.blocks();
        for integrator in INTEGRATORS {
            let p = floor.p(&expected, integrator);
            println!("{integrator:?}: p = {p:.1e}, level {level:.1e}");
            assert!(
                p > level,
                "{integrator:?}, focus {}: p = {p:e}",
                floor.focus
            );
        }
    }
    // A smaller lens.
    let [right, wrong] = [1.4, 1.0].map(|radius| Floor { radius, focus: 2.0 });
    let p = wrong.p(&right.blocks(), Integrator::Light);
    assert!(p < level, "p = {p:e}");
}
