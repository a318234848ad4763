//! A picture of all directions as a light: its radiance is constant within a texel, and texels are drawn by luminance
//! times solid angle. Twin of `shaders/light/surroundings.glsl`.
//!
//! Pharr, Jakob & Humphreys, Physically Based Rendering, 4th edition, section 12.5.2, with directions uniform within a texel's
//! solid angle, so that the density is constant there.

use std::sync::Arc;

use super::outside::Outside;
use super::sample::LightSample;
use crate::film::Film;
use crate::prepared;
pub use crate::prepared::record::surroundings::scalar::Surroundings as Map;
pub use crate::prepared::record::surroundings_row::scalar::SurroundingsRow as Row;
use crate::reference::math::frame::{Frame, to_local, to_world};
use crate::reference::math::{Real, Vec3, vec3};

/// The picture, and the tables by which its texels are drawn.
#[derive(Clone, Debug)]
pub struct Surroundings<F> {
    pub map: Map<F>,
    pub rows: Vec<Row<F>>,
    /// For each texel, where its counts out of 2²⁴ end within its row.
    pub ends: Arc<Vec<u32>>,
    pub picture: Arc<Film>,
}

impl<F: Real> Surroundings<F> {
    /// Each number rounded to the scalar.
    pub fn new(prepared: &prepared::Surroundings) -> Self {
        let rows = prepared.rows.iter();
        Self {
            map: Map::rounded(&prepared.map, F::new),
            rows: rows.map(|row| Row::rounded(row, F::new)).collect(),
            ends: Arc::clone(&prepared.ends),
            picture: Arc::clone(&prepared.picture),
        }
    }

    /// World from the picture's own axes.
    fn frame(&self) -> Frame<F> {
        Frame {
            t: self.map.x,
            b: self.map.y,
            n: self.map.z,
        }
    }
}

/// The texel seen along `wi`: row · width + column, from the top left.
pub fn surroundings_texel<F: Real>(s: &Surroundings<F>, wi: Vec3<F>) -> u32 {
    let d = to_local(s.frame(), wi);
    // u = 1/2 − φ/2π, v = θ/π
    let u = F::new(0.5) - F::turns(d.y, d.x);
    let v = F::new(2.0) * F::turns((d.x * d.x + d.y * d.y).sqrt(), d.z);
    let column = (u * F::from_u32(s.map.width)).to_u32();
    let row = (v * F::from_u32(s.map.height)).to_u32();
    row.min(s.map.height - 1) * s.map.width + column.min(s.map.width - 1)
}

/// The radiance in the picture's file.
pub fn surroundings_radiance<F: Real>(s: &Surroundings<F>, texel: u32) -> Vec3<F> {
    let [r, g, b] = s.picture.rgb[texel as usize].map(|x| F::new(x.into()));
    vec3(r, g, b)
}

/// The probability of the texel over its solid angle: that of its row, times its count out of 2²⁴ within it.
pub fn surroundings_texel_pdf<F: Real>(s: &Surroundings<F>, texel: u32) -> F {
    let before = match texel % s.map.width {
        0 => 0,
        _ => s.ends[texel as usize - 1],
    };
    let count = s.ends[texel as usize] - before;
    F::from_u32(count) * s.rows[(texel / s.map.width) as usize].pdf
}

/// The first row whose counts end above `u24` < 2²⁴.
pub fn surroundings_row<F: Real>(s: &Surroundings<F>, u24: u32) -> u32 {
    s.rows.partition_point(|row| row.end <= u24) as u32
}

/// The texel of the row that begins with texel `first`, by the same rule.
pub fn surroundings_column<F: Real>(s: &Surroundings<F>, first: u32, u24: u32) -> u32 {
    let row = &s.ends[first as usize..(first + s.map.width) as usize];
    first + row.partition_point(|&end| end <= u24) as u32
}

/// Where `u24` lies between the counts `begin` and `end`, from 0 to 1.
pub fn fraction_of<F: Real>(u24: u32, begin: u32, end: u32) -> F {
    (F::from_u32(u24 - begin) + F::new(0.5)) / F::from_u32(end - begin)
}

/// cos θ and sin θ of the place `x` between the edges of a row, by the quantity drawn uniformly: cos θ itself, or
/// sin²(θ/2) = h from the nearer pole. dω = dφ d cos θ = 2 dφ dh.
pub fn height_and_radius<F: Real>(row: u32, height: u32, x: F) -> [F; 2] {
    let middle = 4 * row >= height && 4 * (row + 1) <= 3 * height;
    let south = 2 * row + 1 > height;
    let from_pole = F::one() - (x + x);
    let z = if south { -from_pole } else { from_pole };
    let squared = if middle {
        F::one() - x * x
    } else {
        F::new(4.0) * (x * (F::one() - x))
    };
    [if middle { x } else { z }, squared.sqrt()]
}

/// A direction within a texel, `a` of its width from the left and `b` of its solid angle from the top.
pub fn surroundings_direction<F: Real>(
    s: &Surroundings<F>,
    row: u32,
    column: u32,
    a: F,
    b: F,
) -> Vec3<F> {
    let Row { top, bottom, .. } = s.rows[row as usize];
    let [z, r] = height_and_radius(row, s.map.height, top + b * (bottom - top));
    // φ = 2π(1/2 − u)
    let (sin, cos) = F::sincos_2pi((F::from_u32(column) + a) / F::from_u32(s.map.width));
    let local = vec3(-(r * cos), r * sin, z);
    to_world(s.frame(), local)
}

/// A direction, drawn by the texels' probabilities.
///
/// Its pdf is that of the texel seen along the direction, which rounding may make a neighbour of the one drawn: the
/// radiance that is divided by the pdf is that texel's.
pub fn surroundings_light_sample<F: Real>(s: &Surroundings<F>, u: [F; 2]) -> LightSample<F> {
    let counts = F::new(16_777_216.0);
    let row24 = (u[1] * counts).to_u32();
    let row = surroundings_row(s, row24);
    let row_begin = match row {
        0 => 0,
        _ => s.rows[row as usize - 1].end,
    };
    let b = fraction_of(row24, row_begin, s.rows[row as usize].end);
    let column24 = (u[0] * counts).to_u32();
    let first = row * s.map.width;
    let texel = surroundings_column(s, first, column24);
    let begin = match texel - first {
        0 => 0,
        _ => s.ends[texel as usize - 1],
    };
    let a = fraction_of(column24, begin, s.ends[texel as usize]);
    let wi = surroundings_direction(s, row, texel - first, a, b);
    let seen = surroundings_texel(s, wi);
    LightSample {
        wi,
        distance: -F::one(),
        pdf: surroundings_texel_pdf(s, seen),
        cosine: F::one(),
        prim: seen,
    }
}

/// The light seen along `wi`, times `scale`.
pub fn surroundings_outside<F: Real>(
    s: &Surroundings<F>,
    scale: Vec3<F>,
    wi: Vec3<F>,
) -> Outside<F> {
    let texel = surroundings_texel(s, wi);
    Outside {
        radiance: scale * surroundings_radiance(s, texel),
        pdf: surroundings_texel_pdf(s, texel),
    }
}
