//! The reference for errors, and its own uncertainty.

use super::figures::Figures;
use super::interval::mean;
use crate::film::Film;
use crate::metrics::flip::{Viewing, flip};
use crate::metrics::pair::{check, check_errors, same_size};
use crate::metrics::rel_mse::relative;
use crate::metrics::{MetricsError, Pair, StandardErrors, symmetric_errors, trimmed};

/// The name in errors of the standard errors of a reference.
pub const STANDARD_ERRORS: &str = "reference's standard errors";

/// A picture, or two independent ones with the same mean.
#[derive(Clone, Debug)]
pub struct Reference {
    kind: Kind,
    /// The film for display and for the perceptual metrics: the picture, or the mean of the halves.
    mean: Film,
    /// The error of `mean` itself, if known.
    own: Figures<Option<f64>>,
    /// Standard deviation of the contribution of its noise to the product of any two pictures' errors, weighted as in
    /// relMSE.
    own_spread: f64,
}

#[derive(Clone, Debug)]
enum Kind {
    Picture,
    Halves(Box<[Film; 2]>),
}

impl Reference {
    /// A picture, with the standard errors of its values if known.
    ///
    /// # Errors
    /// No pixels, values that are not finite, standard errors of another size or below 0.
    pub fn picture(film: Film, stderr: Option<StandardErrors>) -> Result<Self, MetricsError> {
        check(&film, "reference")?;
        let mut own = Figures {
            mse: None,
            rmse: None,
            rel_mse: None,
            smape: None,
            flip: None,
        };
        let mut own_spread = 0.0;
        if let Some(StandardErrors {
            film: stderr,
            freedom,
        }) = stderr
        {
            check_errors(stderr, STANDARD_ERRORS)?;
            same_size((stderr, STANDARD_ERRORS), (&film, "reference"))?;
            let mse = mean_of(&film, |c| square(stderr, c));
            let rel = per_pixel(&film, |c| relative(square(stderr, c), value(&film, c)));
            own.mse = Some(mse);
            own.rmse = Some(mse.sqrt());
            own.rel_mse = Some(mean(&rel));
            // (r − µ)² of a normal r has the variance 2 v², v = Var r; its estimate v̂, which is subtracted, 2 v²/ν;
            // and v² is on average v̂² ν/(ν + 2).
            let factor = match freedom.is_finite() {
                true => 2.0 * (freedom + 1.0) / (freedom + 2.0),
                false => 2.0,
            };
            own_spread = spread(factor, &rel);
        }
        Ok(Self {
            kind: Kind::Picture,
            mean: film,
            own,
            own_spread,
        })
    }

    /// Two pictures of the same scene with independent random numbers and equal numbers of samples.
    ///
    /// With x, A and B independent and of the same mean µ, the mean of (x − A)(x − B) is that of (x − µ)²: the halves'
    /// own noise cancels, where a single picture's would add to every error. SMAPE and FLIP are not squares; they use
    /// (A + B)/2.
    ///
    /// # Errors
    /// Sizes that differ, no pixels, values that are not finite.
    pub fn halves(a: Film, b: Film, viewing: &Viewing) -> Result<Self, MetricsError> {
        check(&a, "reference")?;
        check(&b, "reference")?;
        same_size((&a, "reference"), (&b, "reference's other half"))?;
        let film = average(&a, &b);
        // Var (A + B)/2 = E (A − B)²/4; the error of a mean of |·| is half the difference between A and B.
        let quarter = |c: Channel| {
            let d = value(&a, c) - value(&b, c);
            0.25 * d * d
        };
        let mse = mean_of(&film, quarter);
        let rel = per_pixel(&film, |c| relative(quarter(c), value(&film, c)));
        let pair = Pair::new(&a, &b)?;
        let smape = 0.5 * trimmed(&symmetric_errors(&pair)).all;
        let flip = 0.5 * flip(&pair, viewing)?.mean();
        let own = Figures {
            mse: Some(mse),
            rmse: Some(mse.sqrt()),
            rel_mse: Some(mean(&rel)),
            smape: Some(smape),
            flip: Some(flip),
        };
        Ok(Self {
            kind: Kind::Halves(Box::new([a, b])),
            mean: film,
            own,
            // (µ − A)(µ − B) has the variance (Var A)², estimated by 4/3 (A − B)⁴/16: E (A − B)⁴ = 12 (Var A)².
            own_spread: spread(4.0 / 3.0, &rel),
        })
    }

    /// The picture itself, or the mean of its halves.
    pub fn film(&self) -> &Film {
        &self.mean
    }

    /// Its own error in each metric, if known: smaller errors of pictures are not significant.
    pub fn own(&self) -> &Figures<Option<f64>> {
        &self.own
    }

    /// Standard deviation of the reference's own contribution to [`Reference::covariance`], for any pictures.
    pub(super) fn own_spread(&self) -> f64 {
        self.own_spread
    }

    /// The errors of `test`. With halves, squared errors may be below 0 by chance.
    ///
    /// # Errors
    /// A picture of another size, or with values that are not finite.
    pub fn figures(&self, test: &Film, viewing: &Viewing) -> Result<Figures, MetricsError> {
        let pair = Pair::new(test, &self.mean)?;
        let square = |c: Channel| self.product(test, test, c);
        let mse = trimmed(&per_pixel(&self.mean, square));
        let rel = |c: Channel| relative(square(c), value(&self.mean, c));
        Ok(Figures {
            mse,
            rmse: mse.map(|mse| mse.max(0.0).sqrt()),
            rel_mse: trimmed(&per_pixel(&self.mean, rel)),
            smape: trimmed(&symmetric_errors(&pair)),
            flip: trimmed(&flip(&pair, viewing)?.errors),
        })
    }

    pub(super) fn is_halves(&self) -> bool {
        matches!(self.kind, Kind::Halves(_))
    }

    /// Mean over pixels and channels of (x − µ)(y − µ)/(µ² + ε) for two pictures of the reference's size, without the
    /// noise of the halves.
    pub(super) fn covariance(&self, x: &Film, y: &Film) -> f64 {
        mean_of(&self.mean, |c| {
            relative(self.product(x, y, c), value(&self.mean, c))
        })
    }

    /// (x − µ)(y − µ), symmetric in the halves: ½[(x − A)(y − B) + (x − B)(y − A)].
    fn product(&self, x: &Film, y: &Film, c: Channel) -> f64 {
        let (x, y) = (value(x, c), value(y, c));
        match &self.kind {
            Kind::Picture => (x - value(&self.mean, c)) * (y - value(&self.mean, c)),
            Kind::Halves(halves) => {
                let [a, b] = [value(&halves[0], c), value(&halves[1], c)];
                0.5 * ((x - a) * (y - b) + (x - b) * (y - a))
            }
        }
    }
}

/// A pixel and one of its channels.
type Channel = (usize, usize);

fn value(film: &Film, (pixel, channel): Channel) -> f64 {
    f64::from(film.rgb[pixel][channel])
}

fn square(film: &Film, c: Channel) -> f64 {
    value(film, c) * value(film, c)
}

/// The mean of `error` over the channels of each pixel of `film`.
fn per_pixel(film: &Film, error: impl Fn(Channel) -> f64) -> Vec<f64> {
    let of_pixel = |i| (error((i, 0)) + error((i, 1)) + error((i, 2))) / 3.0;
    (0..film.rgb.len()).map(of_pixel).collect()
}

/// Standard deviation of a mean over pixels of independent terms; the sum of the terms' squares, times `factor`,
/// estimates the sum of their variances. The channels of a pixel are assumed to share the same noise.
fn spread(factor: f64, terms: &[f64]) -> f64 {
    let squares: f64 = terms.iter().map(|q| q * q).sum();
    (factor * squares).sqrt() / terms.len() as f64
}

fn mean_of(film: &Film, error: impl Fn(Channel) -> f64) -> f64 {
    mean(&per_pixel(film, error))
}

fn average(a: &Film, b: &Film) -> Film {
    let pixels = a.rgb.iter().zip(&b.rgb);
    Film {
        rgb: pixels
            .map(|(a, b)| [0, 1, 2].map(|c| 0.5 * (a[c] + b[c])))
            .collect(),
        ..*a
    }
}
