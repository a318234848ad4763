//! The weights of all ways to find one path sum to 1, and each is p²/Σp² of densities that are multiplied out.

use std::path::Path;

use vkpt::reference::integrator::bidirectional::partial::{
    Junction, Partial, arrive, from_eye, from_light_point, hit_weight, light_weight, scatter,
    scatter_delta, splat_weight, vertex_weight,
};
use vkpt::reference::world::World;
use vkpt::render::chain::{Chain, Node};
use vkpt::settings::Settings;

use super::chain::chain;
use super::samples;
use crate::common::meshes::cube;
use crate::common::render::prepared;
use crate::common::scenes::{INSIDE, LENS, MANY, SMOOTH, TABLE, WIDE};
use crate::light_tracing::lamps;

/// Mistakes that must be noticed.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Planted {
    Nothing,
    /// The cosine of a direction that is left in.
    Cosine,
    /// dVCM lives on beyond a delta lobe.
    Reset,
    /// Densities forwards and backwards changed over.
    Backwards,
    /// The distance of two vertices that are joined.
    Distance,
}

fn left(at: Partial<f64>, delta: bool, to: Junction<f64>, planted: Planted) -> Partial<f64> {
    if delta {
        let left = scatter_delta(at, to.cosine);
        let vcm = if planted == Planted::Reset {
            at.vcm
        } else {
            left.vcm
        };
        return Partial { vcm, ..left };
    }
    let to = match planted {
        Planted::Cosine => Junction { cosine: 1.0, ..to },
        Planted::Backwards => Junction {
            pdf: to.reverse_pdf,
            reverse_pdf: to.pdf,
            ..to
        },
        _ => to,
    };
    scatter(at, to)
}

fn towards_light(node: &Node) -> Junction<f64> {
    Junction {
        cosine: node.to_light,
        pdf: node.onwards,
        reverse_pdf: node.back,
    }
}

fn towards_eye(node: &Node) -> Junction<f64> {
    Junction {
        cosine: node.to_eye,
        pdf: node.back,
        reverse_pdf: node.onwards,
    }
}

/// The weight of each number of eye vertices, from 1 on, by the recursions of the two subpaths.
fn by_recursion(c: &Chain, planted: Planted) -> Vec<f64> {
    let (n, k) = (&c.nodes, c.nodes.len());
    let (p_n, emission) = (c.source.connection, c.source.start * c.source.leaving);
    let mut eye = vec![from_eye(c.importance, n[0].to_eye)];
    for i in 1..k {
        let along = left(
            eye[i - 1],
            n[i - 1].delta,
            towards_light(&n[i - 1]),
            planted,
        );
        eye.push(arrive(along, n[i].distance, n[i].to_eye));
    }
    let last = left(
        eye[k - 1],
        n[k - 1].delta,
        towards_light(&n[k - 1]),
        planted,
    );
    let mut light = vec![from_light_point(p_n, emission, n[k - 1].to_light)];
    for i in (0..k - 1).rev() {
        let from = &n[i + 1];
        let along = left(light[0], from.delta, towards_eye(from), planted);
        light.insert(0, arrive(along, from.distance, n[i].to_light));
    }
    let vertices = |t: usize| {
        let (x, y) = (&n[t - 2], &n[t - 1]);
        let far = if planted == Planted::Distance {
            1.01
        } else {
            1.0
        };
        let d = y.distance * far;
        vertex_weight(
            eye[t - 2],
            towards_light(x),
            light[t - 1],
            towards_eye(y),
            d,
        )
    };
    let mut weights = vec![splat_weight(light[0], towards_eye(&n[0]), c.importance)];
    weights.extend((2..=k).map(vertices));
    weights.push(light_weight(
        eye[k - 1],
        towards_light(&n[k - 1]),
        p_n,
        emission,
    ));
    weights.push(hit_weight(last, p_n, emission));
    weights
}

/// By densities; `None` where that way cannot find the path.
fn by_densities(c: &Chain) -> Vec<Option<f64>> {
    let squares = (1..=c.nodes.len() + 2).map(|eye| c.density(eye).map(|p| p * p));
    let squares: Vec<Option<f64>> = squares.collect();
    let all: f64 = squares.iter().flatten().sum();
    squares.into_iter().map(|p| p.map(|p| p / all)).collect()
}

/// How far the weights of a path are off, at most, and their sum.
fn off(c: &Chain, planted: Planted) -> f64 {
    let (mut sum, mut most) = (0.0, 0.0);
    for (found, right) in by_recursion(c, planted).into_iter().zip(by_densities(c)) {
        if let Some(right) = right {
            sum += found;
            most = f64::max(most, (found - right).abs());
        }
    }
    f64::max(most, f64::abs(sum - 1.0))
}

/// Calls `f` with paths of a scene that scatter up to eight times; returns how many.
fn paths(text: &str, mut f: impl FnMut(&Chain)) -> usize {
    let settings = Settings::default();
    let prepared = prepared(text, &settings);
    let world = World::<f64>::new(&prepared);
    let mut count = 0;
    for id in samples(&prepared, 64, 5) {
        if let Some(c) = chain(&world, &settings, id).filter(|c| c.nodes.len() <= 8) {
            count += 1;
            f(&c);
        }
    }
    count
}

fn scenes(cube: &Path) -> [(&'static str, String); 7] {
    [
        ("table", TABLE.to_owned()),
        ("smooth", SMOOTH.to_owned()),
        ("wide", WIDE.to_owned()),
        ("many", MANY.to_owned()),
        ("inside", INSIDE.to_owned()),
        ("lens", LENS.to_owned()),
        ("lamps", lamps(cube)),
    ]
}

#[test]
fn weights_are_those_of_densities_multiplied_out() {
    let cube = cube();
    for (name, text) in scenes(cube.path()) {
        let mut most = 0.0;
        let count = paths(&text, |c| most = f64::max(most, off(c, Planted::Nothing)));
        println!("{name}: {count} paths, off by {most:.1e} at most");
        assert!(count >= 100, "{name}: {count} paths");
        assert!(most < 1e-10, "{name}: off by {most:e}");
    }
}

#[test]
fn mistakes_are_noticed() {
    for (planted, text) in [
        (Planted::Cosine, INSIDE),
        (Planted::Reset, SMOOTH),
        (Planted::Backwards, INSIDE),
        (Planted::Distance, INSIDE),
    ] {
        let mut most = 0.0;
        paths(text, |c| most = f64::max(most, off(c, planted)));
        println!("{planted:?}: off by {most:.1e}");
        assert!(most > 1e-3, "{planted:?}: off by {most:e}");
    }
}
