//! The densities of all techniques, as far as a subpath knows them, so that its vertices need not be visited again.
//!
//! A path of k scatterings can be found in k + 2 ways, by s vertices from the light and t from the eye. The weight of
//! one way is p²/Σp² over all of them (power heuristic; Veach 1997, section 9.2.4), and the ratios of the densities of
//! neighbouring ways are products along the path, which each subpath collects for its own side (Georgiev, Implementing
//! Vertex Connection and Merging, 2012: the quantities dVCM and dVC). Stored here are the roots of those sums of
//! squares, because f32 represents densities up to 1e38, but their squares only up to 1e19.
//!
//! Densities contain no roulette, absorption or eta², and those of directions use a choice of lobe that ignores the
//! throughput: both ends must compute the same ones.

use crate::reference::math::{Real, max2, min2};

/// Upper bound of every ratio: products of two are finite, and so is the weight of 0 to which they lead.
pub const MOST: f64 = 1e18;

/// √dVCM and √dVC of a subpath.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Partial<F> {
    /// For the technique that joins the vertex before to the other side, over the subpath's own density.
    pub vcm: F,
    /// For all techniques that join still earlier vertices.
    pub vc: F,
}

/// A vertex at which two paths may meet, as the weights see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Junction<F> {
    /// |Ng·w| of the connection.
    pub cosine: F,
    /// Density per solid angle of the connection's direction, by the subpath that has come here.
    pub pdf: F,
    /// The same for the way back, by a path that came along the connection.
    pub reverse_pdf: F,
}

/// √(a² + b²) of a, b ≥ 0, whose squares may overflow.
pub fn hypot<F: Real>(a: F, b: F) -> F {
    let (most, least) = (max2(a, b), min2(a, b));
    let ratio = least / if most > F::zero() { most } else { F::one() };
    most * (F::one() + ratio * ratio).sqrt()
}

/// No ratio is larger than [`MOST`].
pub fn bounded<F: Real>(x: F) -> F {
    min2(x, F::new(MOST))
}

/// At the first vertex of a light path: `connection_pdf` p_n is the density per solid angle of a connection from here
/// to the light's point, `emission` p_e/cos = P p_A/π, `cosine` |Ng·w| here.
///
/// dVCM = m(p_n c0/(p_e c1)), dVC = m(c0/p_e)/m(c1): the cosine c0 at the light cancels.
pub fn from_light_point<F: Real>(connection_pdf: F, emission: F, cosine: F) -> Partial<F> {
    let vc = bounded(F::one() / (emission * cosine));
    Partial {
        vcm: bounded(connection_pdf * vc),
        vc,
    }
}

/// At the first vertex of an eye path, |Ng·w| = `cosine`, which n_l light paths could have joined to the eye: dVCM =
/// m(n_l t²/(p_c c)), `importance` = p_c/(t² n_l).
pub fn from_eye<F: Real>(importance: F, cosine: F) -> Partial<F> {
    Partial {
        vcm: bounded(F::one() / (importance * cosine)),
        vc: F::zero(),
    }
}

/// At the next vertex, `distance` away, where |Ng·w| = `cosine`: dVCM m(t²)/m(c), dVC/m(c).
pub fn arrive<F: Real>(at: Partial<F>, distance: F, cosine: F) -> Partial<F> {
    Partial {
        vcm: bounded(at.vcm * (distance * distance) / cosine),
        vc: bounded(at.vc / cosine),
    }
}

/// Along a direction that was drawn at a vertex: dVC = m(c/p)(dVC m(p_r) + dVCM), dVCM = m(1/p).
pub fn scatter<F: Real>(at: Partial<F>, to: Junction<F>) -> Partial<F> {
    let back = earlier(at, to.reverse_pdf);
    Partial {
        vcm: bounded(F::one() / to.pdf),
        vc: bounded(to.cosine * back / to.pdf),
    }
}

/// Along a direction of a delta lobe, |Ng·w| = `cosine`: no connection joins its two ends, and p and p_r, two infinite
/// densities, cancel.
pub fn scatter_delta<F: Real>(at: Partial<F>, cosine: F) -> Partial<F> {
    Partial {
        vcm: F::zero(),
        vc: cosine * at.vc,
    }
}

/// √(dVCM + dVC m(p_r))
pub fn earlier<F: Real>(at: Partial<F>, reverse_pdf: F) -> F {
    bounded(hypot(at.vcm, bounded(at.vc * reverse_pdf)))
}

/// 1/(1 + a² + b²)
pub fn weight<F: Real>(a: F, b: F) -> F {
    F::one() / (F::one() + a * a + b * b)
}

/// Weight of a light that an eye path hits, `at` as it was along the ray: `connection_pdf` p_n as in [`from_light_point`],
/// `emission` 0 on the side that sends out no light paths. 1/(1 + m(p_n/p) + m(p_e/cos) dVC).
pub fn hit_weight<F: Real>(at: Partial<F>, connection_pdf: F, emission: F) -> F {
    weight(bounded(connection_pdf * at.vcm), bounded(emission * at.vc))
}

/// Weight of a light that an eye path's vertex is connected to with the density `connection_pdf` p_n per solid angle.
/// 1/(1 + m(p_b/p_n) + m(p_e c_x/(p_n c_l))(dVCM + dVC m(p_r))).
pub fn light_weight<F: Real>(at: Partial<F>, x: Junction<F>, connection_pdf: F, emission: F) -> F {
    let ratio = emission * x.cosine / connection_pdf;
    weight(
        bounded(x.pdf / connection_pdf),
        bounded(ratio * earlier(at, x.reverse_pdf)),
    )
}

/// Weight of a light path's vertex joined to the eye; `importance` as in [`from_eye`].
/// 1/(1 + m(p_c c/(t² n_l))(dVCM + dVC m(p_r))).
pub fn splat_weight<F: Real>(at: Partial<F>, y: Junction<F>, importance: F) -> F {
    let ratio = importance * y.cosine;
    weight(bounded(ratio * earlier(at, y.reverse_pdf)), F::zero())
}

/// Weight of two vertices joined, `distance` apart.
/// 1/(1 + m(p_x c_y/d²)(dVCM_y + dVC_y m(p_r,y)) + m(p_y c_x/d²)(dVCM_x + dVC_x m(p_r,x))).
pub fn vertex_weight<F: Real>(
    eye: Partial<F>,
    x: Junction<F>,
    light: Partial<F>,
    y: Junction<F>,
    distance: F,
) -> F {
    let square = distance * distance;
    let to_y = x.pdf * y.cosine / square;
    let to_x = y.pdf * x.cosine / square;
    weight(
        bounded(to_y * earlier(light, y.reverse_pdf)),
        bounded(to_x * earlier(eye, x.reverse_pdf)),
    )
}
