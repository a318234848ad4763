//! The importance of a node of lights at a point; twin of `shaders/light/tree/importance.glsl`.

use super::LightNode;
use crate::reference::math::{Real, Vec3, dot3, max2};

/// cos(max(0, a − b)) of two angles of [0, π], each given by cosine and sine.
pub fn cos_beyond<F: Real>(cos_a: F, sin_a: F, cos_b: F, sin_b: F) -> F {
    if cos_a > cos_b {
        F::one()
    } else {
        cos_a * cos_b + sin_a * sin_b
    }
}

/// sin(max(0, a − b))
pub fn sin_beyond<F: Real>(cos_a: F, sin_a: F, cos_b: F, sin_b: F) -> F {
    if cos_a > cos_b {
        F::zero()
    } else {
        sin_a * cos_b - cos_a * sin_b
    }
}

/// The sine of an angle of [0, π].
pub fn sine_of<F: Real>(cosine: F) -> F {
    max2(F::one() - cosine * cosine, F::zero()).sqrt()
}

/// power cos θ' cos θ_i'/d²: an estimate of the light that the node's lights send to `p` (Conty Estevez & Kulla,
/// Importance Sampling of Many Lights with Adaptive Tree Splitting, HPG 2018, section 5.1; pbrt 4, section 12.6.3).
///
/// The ball is seen under the angle θ_b, its centre at the angle θ from the axis and θ_i from `n`. Then θ' = max(0, θ −
/// θ_o − θ_b) is the least angle of any normal of the cone to `p`, and θ_i' = max(0, θ_i − θ_b) the least angle of `n`
/// to the ball: the importance is 0 only where no light of the node contributes. Emitters emit on both sides, so cos θ
/// counts without its sign. From inside the ball, d is r and the angles give no bound. n = 0: the point is lit from
/// both sides. `power` is a share of the scene's: radiance times the area seen from afar, summed over the node's lights
/// and RGB.
pub fn node_importance<F: Real>(node: &LightNode<F>, p: Vec3<F>, n: Vec3<F>) -> F {
    let (zero, one) = (F::zero(), F::one());
    let to = node.centre - p;
    let r2 = node.radius * node.radius;
    let d2 = dot3(to, to);
    if d2 <= r2 {
        return node.power / max2(d2, r2);
    }
    let w = to * (one / d2.sqrt());
    let sin_b = (r2 / d2).sqrt();
    let cos_b = (one - sin_b * sin_b).sqrt();
    let cos_w = dot3(node.axis, w).abs();
    let cos_x = cos_beyond(cos_w, sine_of(cos_w), node.cos_o, node.sin_o);
    let sin_x = sin_beyond(cos_w, sine_of(cos_w), node.cos_o, node.sin_o);
    let emitted = cos_beyond(cos_x, sin_x, cos_b, sin_b);
    let cos_i = dot3(n, w);
    let received = max2(cos_beyond(cos_i, sine_of(cos_i), cos_b, sin_b), zero);
    let one_sided = dot3(n, n) > zero;
    let cosines = emitted * if one_sided { received } else { one };
    node.power / max2(d2, r2) * cosines
}
