//! Limits of single precision: refuses scenes beyond its range, and warns about those beyond its resolution.

use super::placed::Placed;
use super::{Camera, Material, PrepareError};
use crate::shape::{Body, Space};

/// An ulp of 1 in f32, 2⁻²³.
pub const ULP: f64 = 1.0 / 8_388_608.0;

/// A shape counts as resolved if rounding moves its parts by less than this share of its size.
const RESOLVED: f64 = 1.0 / 128.0;

/// Below this, in rendering space, the squares of lengths lose digits: √2⁻¹²⁶, with a margin of 2³ for further
/// arithmetic.
const LEAST_LENGTH: f64 = 8.0 / 9_223_372_036_854_775_808.0;

/// The largest contribution of a sample: the sum of 2³² of them, the maximum for a pixel, is below 2¹²⁸, the limit of
/// single precision.
const LARGEST_RADIANCE: f64 = 79_228_162_514_264_337_593_543_950_336.0;

/// Warns about emitters brighter than [`LARGEST_RADIANCE`], including the background, whose line is 0 if there is none.
pub fn warn_of_radiances(
    materials: &[Material],
    background: (f64, usize),
    warnings: &mut Vec<String>,
) {
    let emitters = (materials.iter()).map(|m| (m.radiance.max_element(), m.line));
    for (radiance, line) in emitters.chain([background]) {
        if radiance > LARGEST_RADIANCE {
            warnings.push(format!(
                "line {line}: the radiance {radiance:e} is above 2^96: the sum of 2^32 such samples exceeds single precision, and \
                 samples that overflow count as black",
            ));
        }
    }
}

/// Refuses an index of refraction if its square, or that of its inverse, is infinite on the device.
pub fn check_materials(materials: &[Material]) -> Result<(), PrepareError> {
    // d = n² − 1 and 1/n² − 1: no other value derived from n is larger.
    let fits = |m: &&Material| m.d.iter().all(|d| (*d as f32).is_finite());
    match materials.iter().find(|m| !fits(m)) {
        Some(&Material {
            line,
            eta: [_, ior],
            ..
        }) => Err(PrepareError::Ior { line, ior }),
        None => Ok(()),
    }
}

/// Refuses a picture plane whose width is infinite on the device; `line` is the camera's.
pub fn check_camera(camera: &Camera, line: usize) -> Result<(), PrepareError> {
    if camera.right.as_vec3().is_finite() {
        Ok(())
    } else {
        Err(PrepareError::Camera { line })
    }
}

/// Warns if single precision cannot distinguish the directions of pixels; `line` is the camera's.
pub fn warn_of_narrow(camera: &Camera, line: usize, warnings: &mut Vec<String>) {
    let pixel = 2.0 * camera.up.length() / f64::from(camera.height);
    if pixel < ULP {
        warnings.push(format!(
            "line {line}: the camera's pixels are {pixel:.0e} wide, but single precision resolves directions to {ULP:.0e}: \
             many see the same point"
        ));
    }
}

/// Warns about shapes that are too small for their position.
pub fn warn_of_small(placed: &Placed, space: &Space, warnings: &mut Vec<String>) {
    let sizes = placed
        .shapes
        .iter()
        .map(|s| (s, Size::of(&*placed.body(s))));
    let mut small = sizes.filter(|(_, size)| !size.is_resolved());
    let Some((first, size)) = small.next() else {
        return;
    };
    let away = space.unit * size.away;
    let thick = space.unit * size.thickness;
    let others = match small.count() {
        0 => String::new(),
        n => format!("; the same applies to {n} more shapes"),
    };
    let line = first.line;
    let apart = away * ULP;
    let squares = match size.thickness < LEAST_LENGTH {
        true => format!(
            ", and in a scene of size {:.1e} cannot square lengths below {:.0e}",
            space.unit,
            space.unit * LEAST_LENGTH
        ),
        false => String::new(),
    };
    warnings.push(format!(
        "the shape of line {line} is {thick:.1e} thick, {away:.1e} from the middle of the scene, where single precision resolves \
         places to {apart:.0e}{squares}: its place or shape will differ from the file{others}"
    ));
}

/// Enlarges radii and heights whose squares underflow in single precision to the least usable length, so that quotients
/// stay finite. The user has been warned about them.
pub fn enlarge(placed: &mut Placed) {
    placed
        .primitives
        .iter_mut()
        .for_each(|p| p.enlarge(LEAST_LENGTH));
}

/// The size of a shape, and its reach from the middle of the scene.
struct Size {
    thickness: f64,
    away: f64,
}

impl Size {
    fn of(body: &dyn Body) -> Self {
        let bounds = body.bounds();
        Self {
            thickness: body.thickness(),
            away: bounds.lo.abs().max(bounds.hi.abs()).max_element(),
        }
    }

    fn is_resolved(&self) -> bool {
        self.thickness >= LEAST_LENGTH.max(0.5 * ULP * self.away / RESOLVED)
    }
}
