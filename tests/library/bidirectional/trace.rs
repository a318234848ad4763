//! `--trace` of both paths: the weights that it multiplies out are those that the integrator takes.

use std::collections::HashMap;

use vkpt::reference::integrator::bidirectional::joint::Joint;
use vkpt::reference::integrator::bidirectional::record::{Far, Recorder};
use vkpt::reference::integrator::bidirectional::{Transport, Ways, trace_bidirectional};
use vkpt::reference::math::Vec3;
use vkpt::reference::path::blocks::Origin;
use vkpt::reference::world::World;
use vkpt::render::{Target, trace};
use vkpt::settings::{Integrator, Lights};

use super::{samples, whole};
use crate::common::render::{job, prepared};
use crate::common::scenes::{INSIDE, LENS, SMOOTH, TABLE, WIDE};
use crate::common::settings::by;

/// The light that arrived over each connection, by the numbers of vertices from the light and from the eye.
#[derive(Default)]
struct Arrived {
    eye: u32,
    light: u32,
    all: HashMap<(u32, u32), f64>,
}

impl Recorder<f64> for Arrived {
    fn hit(&mut self, from: Origin, x: &Joint<f64>) {
        match from {
            Origin::Eye => self.eye = x.count,
            Origin::Light => self.light = x.count,
        }
    }

    fn connection(&mut self, far: Far<f64>, arrived: Option<Vec3<f64>>) {
        let way = match far {
            Far::Eye { .. } => (self.light, 1),
            Far::Light(_) => (1, self.eye),
            Far::Vertex(y) => (y.count, self.eye),
        };
        self.all.extend(arrived.map(|light| (way, light.x)));
    }
}

/// The text about one way: the light in red, and the weight of the row that is marked.
fn weights(text: &str) -> Vec<((u32, u32), f64, f64)> {
    let number = |s: &str| s.parse::<f64>().expect("a number");
    let mut all = Vec::new();
    let mut way = None;
    for line in text.lines() {
        // The left column is that of f64.
        let left: String = line.chars().take(70).collect();
        let words: Vec<&str> = left.split_whitespace().collect();
        match words[..] {
            [s, t, ..] if left.starts_with("s=") => {
                let count = |w: &str| w[2..].trim_end_matches(':').parse().expect("a count");
                way = Some(((count(s), count(t)), 0.0));
            }
            ["light", red, ..] if left.starts_with("    ") => {
                way = way.map(|(w, _)| (w, number(red)))
            }
            [.., weight, "*"] => {
                let ((s, t), red) = way.expect("a connection before its rows");
                all.push(((s, t), red, number(weight)));
            }
            _ => {}
        }
    }
    all
}

/// The largest error of the weights in the text, and their number; the text's weights are multiplied by `factor`.
fn compared(factor: f64) -> (f64, usize) {
    let mut settings = by(Integrator::Bidirectional);
    // By contribution, weights decide which light is chosen.
    settings.estimator.lights = Lights::Power;
    let adjoint = settings.adjoint();
    let (mut off, mut count) = (0.0, 0);
    for text in [TABLE, SMOOTH, WIDE, INSIDE, LENS] {
        let scene = prepared(text, &settings);
        let world = World::<f64>::new(&scene);
        for id in samples(&scene, 1, 1).step_by(3) {
            let job = job(&scene, settings, 1, 1);
            let trace = trace(&job, &Target::CpuF64, [id.column, id.row], 0).expect("a trace");
            for ((light, eye), red, weight) in weights(&trace.to_string()) {
                let transport = Transport {
                    world: &world,
                    settings: &settings,
                    adjoint: &adjoint,
                    ways: Ways::Only { light, eye },
                };
                let mut alone = Arrived::default();
                trace_bidirectional(transport, whole(&scene), id, &mut alone, &mut |_| {});
                // The way alone has the weight 1. Light that the eye path hits is no connection.
                let unweighted = alone.all.get(&(light, eye)).filter(|x| **x > 1e-6);
                if let Some(unweighted) = unweighted {
                    off = f64::max(off, (factor * weight - red / unweighted).abs());
                    count += 1;
                }
            }
        }
    }
    (off, count)
}

#[test]
fn weights_multiplied_out_are_those_that_light_is_weighed_by() {
    let (off, count) = compared(1.0);
    println!("{count} connections, off by {off:.1e} at most");
    assert!(count > 500, "{count}");
    // Seven decimals are printed.
    assert!(off < 1e-6, "{off:e}");
    let (planted, _) = compared(0.999);
    assert!(planted > 1e-4, "{planted:e}");
}
