//! The targets of light paths: the shapes that concentrate light, enclosed in a few balls.

use super::placed::Placed;
use super::record::aim::Aim;
use super::{Light, Material, Shape};

/// Maximum number of balls: each costs every light path a test.
const AIMS: usize = 4;

/// Balls around the shapes that refract or mirror. If there are more than [`AIMS`], the pairs with the smallest common
/// ball are merged.
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
    join(&mut all, AIMS);
    all
}

/// Merges balls until `most` remain: always the pair with the smallest common ball, the first among equals.
///
/// The best earlier partner of each ball is stored, so a merge takes linear instead of quadratic time.
fn join(all: &mut Vec<Aim>, most: usize) {
    let mut best: Vec<(f64, usize)> = (0..all.len()).map(|j| best_before(all, j)).collect();
    while all.len() > most {
        let Some(j) = (0..all.len()).min_by(|&a, &b| best[a].0.total_cmp(&best[b].0)) else {
            return;
        };
        let i = best[j].1;
        all[i] = both(&all[i], &all[j]);
        all.remove(j);
        best.remove(j);
        best[i] = best_before(all, i);
        for k in i + 1..all.len() {
            let (size, partner) = best[k];
            if partner == i || partner == j {
                best[k] = best_before(all, k);
                continue;
            }
            let kept = (size, partner - usize::from(partner > j));
            let new = (both(&all[i], &all[k]).radius, i);
            let is_better = new.0.total_cmp(&kept.0).then(new.1.cmp(&kept.1)).is_lt();
            best[k] = if is_better { new } else { kept };
        }
    }
}

/// The radius of the smallest common ball of `all[j]` and an earlier one, and the index of that one; infinite for the
/// first ball.
fn best_before(all: &[Aim], j: usize) -> (f64, usize) {
    let sizes = (0..j).map(|i| (both(&all[i], &all[j]).radius, i));
    let least = sizes.min_by(|a, b| a.0.total_cmp(&b.0));
    least.unwrap_or((f64::INFINITY, 0))
}

/// The smallest share of all directions that an emitting shape fills, as seen from the centre of an aim: a convex body
/// of area A shows A/4 on average (Cauchy), so A/(16π d²). 0 if an emitter is within the ball of an aim, in glass or
/// behind it; `None` without emitters or aims.
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

/// The smallest ball around two.
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

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    /// A plain version that inspects every pair in every step.
    fn join_plainly(all: &mut Vec<Aim>, most: usize) {
        while all.len() > most {
            let pairs = (0..all.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
            let size = |&(i, j): &(usize, usize)| both(&all[i], &all[j]).radius;
            let (i, j) = pairs
                .min_by(|a, b| size(a).total_cmp(&size(b)))
                .expect("a pair");
            let other = all.remove(j);
            all[i] = both(&all[i], &other);
        }
    }

    #[test]
    fn the_smallest_balls_are_joined_whatever_is_remembered() {
        let mut state = 7_u64;
        let mut unit = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            // Few positions, so that many balls have the same size.
            (state >> 60) as f64 / 4.0
        };
        for count in 0..60 {
            let mut ball = || Aim {
                centre: DVec3::new(unit(), unit(), unit()),
                radius: unit() / 8.0,
            };
            let balls: Vec<Aim> = (0..count).map(|_| ball()).collect();
            for most in [1, 4] {
                let (mut quickly, mut plainly) = (balls.clone(), balls.clone());
                join(&mut quickly, most);
                join_plainly(&mut plainly, most);
                assert_eq!(format!("{quickly:?}"), format!("{plainly:?}"));
            }
        }
    }
}
