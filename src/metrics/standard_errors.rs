//! The noise of a picture.

use crate::film::Film;

/// Standard errors of a picture's values.
///
/// The square of each is an unbiased estimate v̂ of the variance v of its value, with ν degrees of freedom: ν v̂/v is
/// chi-square distributed where the noise is normal, so that Var v̂ = 2 v²/ν and E v̂² = v² (ν + 2)/ν. With few
/// degrees, an estimate says little about one pixel. A sum of squares over many pixels has as many more.
#[derive(Clone, Copy, Debug)]
pub struct StandardErrors<'a> {
    /// For each pixel and channel, in the picture's unit.
    pub film: &'a Film,
    /// ν of each value, above 0; infinite if the errors are known exactly.
    pub freedom: f64,
}

impl<'a> StandardErrors<'a> {
    /// Exactly known errors.
    pub fn exact(film: &'a Film) -> Self {
        let freedom = f64::INFINITY;
        Self { film, freedom }
    }
}
