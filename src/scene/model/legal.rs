//! Legal values of a document's numbers. Errors are messages.

use glam::DVec3;

use super::left_out::LeftOut;

/// Checks the numbers of one object. Shares above 1 count as 1, as in scene files.
pub(super) struct Legal<'a> {
    pub(super) label: &'a str,
    pub(super) left_out: &'a mut LeftOut,
}

impl Legal<'_> {
    /// A number of 0 to 1.
    pub(super) fn share(&mut self, name: &str, x: f64) -> Result<f64, String> {
        let x = not_negative(name, x)?;
        if x > 1.0 {
            let what = format!("its {name} is above 1: taken as 1");
            self.left_out.note(what, self.label);
        }
        Ok(x.min(1.0))
    }

    /// A colour with three such channels.
    pub(super) fn shares(&mut self, name: &str, [r, g, b]: [f64; 3]) -> Result<DVec3, String> {
        let mut share = |x| self.share(name, x);
        Ok(DVec3::new(share(r)?, share(g)?, share(b)?))
    }
}

/// A number of 0 or more.
pub(super) fn not_negative(name: &str, x: f64) -> Result<f64, String> {
    let x = finite(name, x)?;
    match x >= 0.0 {
        true => Ok(x),
        false => Err(format!("its {name} must not be negative")),
    }
}

/// A number above 0, in single precision too, because the renderer divides by it.
pub(super) fn positive(name: &str, x: f64) -> Result<f64, String> {
    let x = finite(name, x)?;
    match x as f32 > 0.0 {
        true => Ok(x),
        false => Err(format!("its {name} must be above 0")),
    }
}

fn finite(name: &str, x: f64) -> Result<f64, String> {
    match (x as f32).is_finite() {
        true => Ok(x),
        false => Err(format!("its {name} is not finite in single precision")),
    }
}
