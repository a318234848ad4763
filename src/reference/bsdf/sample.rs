//! Arguments and results of sampling and evaluation; twin of `shaders/bsdf/sample.glsl`.

pub use crate::layout::constants::lobe::{
    LOBE_DELTA, LOBE_DIFFUSE, LOBE_NONE, LOBE_REFLECTION, LOBE_TRANSMISSION,
};
use crate::reference::math::finite::is_finite;
use crate::reference::math::{Real, Vec3, vec3};

/// The random numbers of one draw, uniform in [0, 1).
#[derive(Clone, Copy, Debug)]
pub struct BsdfRandom<F> {
    /// Between the diffuse lobe and the rest.
    pub lobe: F,
    /// Between reflection and refraction.
    pub reflect: F,
    /// The micro-normal.
    pub m: [F; 2],
    /// The diffuse direction.
    pub d: [F; 2],
}

/// A sampled direction.
#[derive(Clone, Copy, Debug)]
pub struct BsdfSample<F> {
    /// In the frame of N', of unit length.
    pub wi: Vec3<F>,
    /// value·|N·wi| / density, per channel.
    pub weight: Vec3<F>,
    /// Density of `wi` per solid angle, over all lobes; meaningless for a delta lobe.
    pub pdf: F,
    /// `LOBE_…`, with [`LOBE_DELTA`] or without.
    pub lobe: u32,
}

/// The parts of a BSDF that have a density, for one pair of directions.
#[derive(Clone, Copy, Debug)]
pub struct BsdfValue<F> {
    /// value·|N·wi|, per channel.
    pub value: Vec3<F>,
    /// Density of sampling `wi` per solid angle.
    pub pdf: F,
}

/// No direction.
pub fn no_sample<F: Real>() -> BsdfSample<F> {
    BsdfSample {
        wi: vec3(F::zero(), F::zero(), F::one()),
        weight: Vec3::zero(),
        pdf: F::zero(),
        lobe: LOBE_NONE,
    }
}

/// No light goes this way.
pub fn no_value<F: Real>() -> BsdfValue<F> {
    BsdfValue {
        value: Vec3::zero(),
        pdf: F::zero(),
    }
}

/// `value`, or zero.
pub fn value_if<F: Real>(valid: bool, value: BsdfValue<F>) -> BsdfValue<F> {
    if valid { value } else { no_value() }
}

/// The sample `wi`, unless it is invalid or its density is 0. A broken density breaks the weight: the film counts it.
pub fn sample_or_none<F: Real>(
    valid: bool,
    wi: Vec3<F>,
    value: BsdfValue<F>,
    lobe: u32,
) -> BsdfSample<F> {
    let found = BsdfSample {
        wi,
        weight: value.value / value.pdf,
        pdf: value.pdf,
        lobe,
    };
    if valid && (value.pdf > F::zero() || !is_finite(value.pdf)) {
        found
    } else {
        no_sample()
    }
}
