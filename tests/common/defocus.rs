//! A ball of light out of focus (model.md, "Ball of light out of focus"): the disc that it makes on the picture, in closed form
//! and in f64, by nothing that a renderer has.
//!
//! The eye is the origin and looks along z; R is the lens's radius, F the distance that is sharp. A ball of radius ρ whose
//! centre is d deep and s off the axis of a pinhole covers the area
//!
//! π ρ² √(d² + s² − ρ²) / √(d² − ρ²)³
//!
//! of the plane at distance 1: the contour is an ellipse with the half axes ρ/√(d² − ρ²) and
//! ρ √(d² + s² − ρ²)/(d² − ρ²). (Cut the cone of half angle asin ρ/√(d² + s²) about the ball's centre by the plane.)

use vkpt::film::Film;

use super::render::pixel_means;

/// Pixels a side of the picture.
pub const SIDE: usize = 24;
/// Half of it on the plane at distance 1.
const HALF: f64 = 0.3;

/// A ball of light of radiance 1, and the lens that sees it.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub lens: f64,
    pub focus: f64,
    pub radius: f64,
    /// Off the axis, and how deep.
    pub at: [f64; 2],
    pub depth: f64,
}

/// The half axes of that ellipse, and how far its middle is from the projection of the ball's, which is at s/d.
fn contour(radius: f64, depth: f64, aside: f64) -> (f64, f64, f64) {
    let square = depth * depth - radius * radius;
    let long = radius * (square + aside * aside).sqrt() / square;
    let off = aside * depth / square - aside / depth;
    (radius / square.sqrt(), long, off)
}

fn contour_area(radius: f64, depth: f64, aside: f64) -> f64 {
    let (short, long, _) = contour(radius, depth, aside);
    std::f64::consts::PI * short * long
}

impl Ball {
    /// The scene; its light comes from the ball alone.
    pub fn scene(&self) -> String {
        let Self {
            lens,
            focus,
            radius,
            at: [x, y],
            depth,
        } = self;
        format!(
            "screen {SIDE} {SIDE}\ncamera 0 0 0 {HALF}\nlens {lens} {focus}\nlight 1 1 1\nsphere {x} {y} -{depth} {radius}\n"
        )
    }

    /// The mean over the picture, which contains all of the disc: each point l of the lens is a pinhole that sees the ball.
    /// By 200 × 200 points of the lens, whose integrand is smooth: its second differences leave 1e-5.
    pub fn mean(&self) -> f64 {
        const N: usize = 200;
        let area = |k: usize| {
            let (ring, turn) = (k / N, k % N);
            let r = self.lens * ((ring as f64 + 0.5) / N as f64).sqrt();
            let (sin, cos) = (std::f64::consts::TAU * turn as f64 / N as f64).sin_cos();
            let aside = (r * cos - self.at[0]).hypot(r * sin - self.at[1]);
            contour_area(self.radius, self.depth, aside)
        };
        let mean = (0..N * N).map(area).sum::<f64>() / (N * N) as f64;
        mean / (4.0 * HALF * HALF)
    }

    /// Radiance at the point x of the plane at distance 1, where it is known: the point f = (F x, F) sees the ball before the
    /// lens or behind it, and the area of the lens's plane that the ball covers, all of it or nothing within the lens, is the
    /// share of rays that meet the ball.
    fn radiance(&self, x: [f64; 2]) -> Option<f64> {
        let (f, h) = (x.map(|x| self.focus * x), (self.focus - self.depth).abs());
        let aside = (f[0] - self.at[0]).hypot(f[1] - self.at[1]);
        let (short, long, off) = contour(self.radius, h, aside);
        // The line from f through the ball's middle, in the lens's plane.
        let on_lens =
            |k: usize| f[k] + (self.at[k] - f[k]) * self.focus / (self.focus - self.depth);
        let middle = on_lens(0).hypot(on_lens(1));
        let reach = self.focus * (short.max(long) + off);
        if middle + reach < self.lens {
            let area = contour_area(self.radius, h, aside) * self.focus * self.focus;
            Some(area / (std::f64::consts::PI * self.lens * self.lens))
        } else if middle - reach > self.lens {
            Some(0.0)
        } else {
            None
        }
    }

    /// The mean over each pixel, where it is known: by 4 × 4 points. The radiance varies by √(1 + s²/h²): by a few per cent
    /// over the picture, so the error of the points is far below 1e-4.
    pub fn pixels(&self) -> Vec<Option<f64>> {
        let at = |k: f64| HALF * (2.0 * k / SIDE as f64 - 1.0);
        let point = |i: usize, a: f64, b: f64| {
            let (column, row) = ((i % SIDE) as f64, (i / SIDE) as f64);
            self.radiance([at(column + a), -at(row + b)])
        };
        let pixel = |i: usize| {
            let corner = |k: usize| point(i, (k % 2) as f64, (k / 2) as f64);
            let corners: Vec<f64> = (0..4).filter_map(corner).collect();
            let dark = corners.iter().filter(|r| **r == 0.0).count();
            if corners.len() < 4 || (dark != 0 && dark != 4) {
                return None;
            }
            let inner = |k: usize| {
                point(
                    i,
                    (k % 4) as f64 / 4.0 + 0.125,
                    (k / 4) as f64 / 4.0 + 0.125,
                )
            };
            Some((0..16).filter_map(inner).sum::<f64>() / 16.0)
        };
        (0..SIDE * SIDE).map(pixel).collect()
    }
}

/// Means of pictures by several seeds, over the expected ones: the whole, and the disc's inside; and the largest value of a
/// pixel outside of it.
pub struct Found {
    pub whole: Vec<f64>,
    pub inside: Vec<f64>,
    pub outside: f64,
}

pub fn found(ball: &Ball, films: impl IntoIterator<Item = Film>) -> Found {
    let (mean, expected) = (ball.mean(), ball.pixels());
    let mut found = Found {
        whole: Vec::new(),
        inside: Vec::new(),
        outside: 0.0,
    };
    for film in films {
        let pixels = pixel_means(&film);
        found
            .whole
            .push(pixels.iter().sum::<f64>() / pixels.len() as f64 / mean);
        let known = pixels.iter().zip(&expected);
        let known: Vec<(f64, f64)> = known.filter_map(|(p, e)| Some((*p, (*e)?))).collect();
        let inside: Vec<f64> = known
            .iter()
            .filter(|k| k.1 > 0.0)
            .map(|(p, e)| p / e)
            .collect();
        assert!(
            inside.len() > 30,
            "{ball:?}: {} pixels inside",
            inside.len()
        );
        found
            .inside
            .push(inside.iter().sum::<f64>() / inside.len() as f64);
        let outside = known.iter().filter(|k| k.1 == 0.0).map(|k| k.0);
        found.outside = outside.fold(found.outside, f64::max);
    }
    found
}

/// One behind the sharp plane, and one before it: discs of eight pixels' radius next to the middle.
pub const BALLS: [Ball; 2] = [
    Ball {
        lens: 0.4,
        focus: 1.0,
        radius: 0.1,
        at: [0.12, -0.06],
        depth: 2.0,
    },
    Ball {
        lens: 0.6,
        focus: 4.0,
        radius: 0.06,
        at: [-0.05, 0.1],
        depth: 1.7142857142857142,
    },
];
