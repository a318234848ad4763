//! What light paths are aimed at: the shapes that gather light, few balls about all of them.

use super::placed::Placed;
use super::record::aim::Aim;
use super::{Light, Material, Shape};

/// Balls at most: each costs every light path a test.
const AIMS: usize = 4;

/// Balls about the shapes that refract or mirror; of more than [`AIMS`] those grow together that make the smallest ball.
pub fn aims(placed: &Placed, materials: &[Material]) -> Vec<Aim> {
    let shapes = placed.shapes.iter();
    let gathers = shapes.filter(|s| materials[s.material as usize].gathers());
    let mut all: Vec<Aim> = gathers
        .map(|shape| {
            let body = placed.body(shape);
            let bounds = body.bounds();
            let (centre, radius) = body.ball().unwrap_or((bounds.centre(), bounds.radius()));
            Aim { centre, radius }
        })
        .collect();
    while all.len() > AIMS {
        let pairs = (0..all.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let size = |&(i, j): &(usize, usize)| both(&all[i], &all[j]).radius;
        let Some((i, j)) = pairs.min_by(|a, b| size(a).total_cmp(&size(b))) else {
            break;
        };
        let other = all.remove(j);
        all[i] = both(&all[i], &other);
    }
    all
}

/// The least share of all directions that a shape that shines fills, as the centre of an aim sees it: A/4 of a convex body of area
/// A is seen on average (Cauchy), so A/(16π d²). 0 where one stands within the ball of an aim, in glass or behind it; none without
/// either.
pub fn light_share(placed: &Placed, lights: &[Light], aims: &[Aim]) -> Option<f64> {
    let shine = (lights.iter()).filter_map(|light| placed.shapes.get(light.shape as usize));
    let share = |shape: &Shape| {
        let body = placed.body(shape);
        let (area, centre): (f64, _) = (body.areas().iter().sum(), body.bounds().centre());
        aims.iter()
            .map(move |aim| match centre.distance(aim.centre) {
                d if d <= aim.radius => 0.0,
                d => area / (16.0 * std::f64::consts::PI * d * d),
            })
            .reduce(f64::min)
    };
    shine.filter_map(share).reduce(f64::min)
}

/// The smallest ball about two.
fn both(a: &Aim, b: &Aim) -> Aim {
    let way = b.centre - a.centre;
    let distance = way.length();
    match () {
        () if distance + b.radius <= a.radius => *a,
        () if distance + a.radius <= b.radius => *b,
        () => {
            let radius = (distance + a.radius + b.radius) * 0.5;
            Aim {
                centre: a.centre + way * ((radius - a.radius) / distance),
                radius,
            }
        }
    }
}
