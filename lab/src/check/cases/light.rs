//! Lights that are tiny and bright, that touch the surface they light, that are inside glass; none at all, and 10,000.

use crate::check::case::{Case, Stiffness};
use crate::check::closed::interface::fresnel;
use crate::check::closed::slab::attenuation;

pub fn cases() -> Vec<Case> {
    vec![
        tiny(),
        touching(0.1),
        touching(1e-3),
        in_glass(),
        no_light(),
        no_shape(),
        many(),
    ]
}

/// Radiance of a Lambert floor that a ball of radius r lights, d away at cos θ, all of it above the horizon:
/// Kd L r² cos θ/d² (the form factor of a sphere and a surface element, Howell's catalogue B-43).
fn lambert(kd: f64, radiance: f64, r: f64, d2: f64, cos: f64) -> f64 {
    kd * radiance * r * r * cos / d2
}

const FLOOR: &str = "brdf .5 .5 .5 0 0 0 1\nbox -100 -100 -1 200 200 1\n";

fn tiny() -> Case {
    let text =
        format!("screen 16 16\ncamera 0 0 1 1e-9\nlight 1e7 1e7 1e7\nsphere 3 0 3 1e-3\n{FLOOR}");
    let stiff = Stiffness::new(
        2.0,
        1.0,
        1.0,
        "the light's cone is known from r²/d², without cancellation",
    );
    let value = lambert(0.5, 1e7, 1e-3, 18.0, 0.5f64.sqrt());
    Case::new(
        "light/tiny",
        "a light of radius 1e-3 and radiance 1e7",
        text,
        stiff,
    )
    .mean(value, "Kd L r² cos θ/d²")
}

/// A ball on the floor lights a point `x` from where it touches; the eye looks along the floor, below the ball.
fn touching(x: f64) -> Case {
    // At a slope below 2x the ray passes under the ball, which is s²/2 above the floor at s.
    let slope = x;
    let degrees = (1.0 / slope).atan().to_degrees();
    let text = format!(
        "screen 16 16\ncamera {} 0 {} 1e-9 z 90 x {degrees}\nlight 1 1 1\nsphere 0 0 1 1\n{FLOOR}",
        x + 2.0,
        2.0 * slope
    );
    let d2 = 1.0 + x * x;
    let stiff = Stiffness::new(
        2.0,
        1.0 / slope,
        1.0 / slope,
        "an error of height becomes one of place by 1/slope",
    );
    Case::new(
        format!("light/touching-{x:e}"),
        format!("a ball of light on the floor, seen {x} from where it touches"),
        text,
        stiff,
    )
    .spp(64)
    .mean(
        lambert(0.5, 1.0, 1.0, d2, 1.0 / d2.sqrt()),
        "Kd L r² cos θ/d²",
    )
}

fn in_glass() -> Case {
    let text = "screen 16 16\ncamera 0 0 3 1e-9\nlight 1 1 1\nsphere 0 0 0 .25\nfresnel exact\n\
                brdf 0 0 0 .04 .04 .04 0 .5 .5 .5 1.5\nsphere 0 0 0 1\n";
    let stiff = Stiffness::new(2.0, 1.0, 1.0, "two vertices along the normal");
    let value = (1.0 - fresnel(0.0, 1.0, 1.5)) / 2.25 * attenuation(0.5, 0.75);
    Case::new(
        "light/in-glass",
        "a light in the middle of a ball of glass",
        text,
        stiff,
    )
    .spp(64)
    .mean(value, "(1 − F)/n² · Kt^.75")
}

fn no_light() -> Case {
    let stiff = Stiffness::new(3.0, 1.0, 1.0, "flat and dark");
    Case::new(
        "light/none",
        "a scene without light",
        format!("screen 16 16\ncamera 0 0 1 1\n{FLOOR}"),
        stiff,
    )
    .mean(0.0, "there is no light")
}

fn no_shape() -> Case {
    let stiff = Stiffness::new(1.0, 1.0, 1.0, "no vertex");
    Case::new(
        "light/sky-alone",
        "a scene without shapes",
        "screen 16 16\ncamera 0 0 1 1\nbackground .5 .5 .5\n",
        stiff,
    )
    .mean(0.5, "the sky's radiance")
}

/// 100 × 100 balls 10 above the floor, none of which hides another.
fn many() -> Case {
    let places = || (0..10_000).map(|i| [f64::from(i % 100) - 49.5, f64::from(i / 100) - 49.5]);
    let lights: String = places()
        .map(|[x, y]| format!("sphere {x} {y} 10 .01\n"))
        .collect();
    let text = format!("screen 16 16\ncamera 0 0 1 1e-9\nlight 1e5 1e5 1e5\n{lights}{FLOOR}");
    let value = places().map(|[x, y]| {
        let d2 = x * x + y * y + 100.0;
        lambert(0.5, 1e5, 0.01, d2, 10.0 / d2.sqrt())
    });
    let stiff = Stiffness::new(
        2.0,
        1.0,
        1.0,
        "one choice among 10,000, by an integer table",
    );
    Case::new("light/10000", "10,000 lights", text, stiff)
        .spp(64)
        .mean(value.sum(), "the sum of Kd L r² cos θ/d²")
}
