//! Sine and cosine of a fraction of the full turn.

use crate::reference::math::Real;

/// (sin 2πu, cos 2πu) for u in [0, 1].
pub fn sincos_2pi(u: f32) -> (f32, f32) {
    let (k, r) = quadrant(u);
    let z = r * r;
    // sin(πr/2) = r + r (π/2 − 1) + r³ S(r²), relative error 2⁻²⁷·⁹. r is exact, so only the smaller part of the sum
    // carries rounding errors; π/2 − 1 in two parts.
    let s = r * (z * (-0.6459636 + z * (0.07968108 + z * -0.004603732)) + 1.5893255e-8);
    let sin_r = r + (r * 0.5707963 + s);
    // cos(πr/2) = 1 + r² C(r²), error 2⁻³¹
    let cos_r = 1.0 + z * (-1.2337005 + z * (0.25366855 + z * (-0.020855596 + z * 0.0008944864)));
    rotate_by_quadrant(k, sin_r, cos_r)
}

/// (k, r) with 4u = k + r, k whole and |r| ≤ 1/2. No operation rounds.
pub fn quadrant<F: Real>(u: F) -> (F, F) {
    let t = F::new(4.0) * u;
    let k = t.floor();
    let f = t - k;
    let up = f > F::new(0.5);
    (
        if up { k + F::one() } else { k },
        if up { f - F::one() } else { f },
    )
}

/// (sin, cos) of (k + r) quarter turns from those of r quarter turns, k in 0 … 4.
pub fn rotate_by_quadrant<F: Real>(k: F, sin_r: F, cos_r: F) -> (F, F) {
    let q = k.to_u32();
    let odd = (q & 1) != 0;
    let s = if odd { cos_r } else { sin_r };
    let c = if odd { sin_r } else { cos_r };
    (
        if (q & 2) != 0 { -s } else { s },
        if ((q + 1) & 2) != 0 { -c } else { c },
    )
}
