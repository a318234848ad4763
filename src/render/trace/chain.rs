//! A whole path from the eye to a light, with the quantities that all techniques need of its vertices.

use crate::reference::camera::eye_importance;
use crate::reference::integrator::bidirectional::aim::aimed_density;
use crate::reference::integrator::bidirectional::bend::reverse_pdf;
use crate::reference::integrator::path::pick::{pick_normal, pick_probability};
use crate::reference::math::{Real, Vec3, dot3, length3};
use crate::reference::path::vertex::Vertex;
use crate::reference::world::World;
use crate::settings::Settings;

/// A vertex that scatters: `wo` leads to the vertex before, counted from the eye, and `wi` to the one after; both of
/// unit length. `delta`: by a delta lobe.
#[derive(Clone, Copy, Debug)]
pub struct Bounce<F> {
    pub v: Vertex<F>,
    pub wo: Vec3<F>,
    pub wi: Vec3<F>,
    pub delta: bool,
}

/// The light at which a path ends.
#[derive(Clone, Copy, Debug)]
pub enum End<F> {
    /// The point `p` of a primitive of a light, which the path meets with the cosine |N·w| = `cosine`.
    Point {
        light: usize,
        prim: u32,
        p: Vec3<F>,
        cosine: F,
    },
    /// The background, infinitely far away.
    Background { light: usize },
}

/// A vertex that scatters, as densities see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// |Ng·w| to the vertex before and to the one after, counted from the eye.
    pub to_eye: f64,
    pub to_light: f64,
    /// To the vertex before.
    pub distance: f64,
    /// Densities per solid angle of continuing to the light, and to the eye; 1 for a delta lobe.
    pub onwards: f64,
    pub back: f64,
    pub delta: bool,
}

/// The end of a path at a light, as densities see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// From the last node to the light's point; 1 to the background.
    pub distance: f64,
    /// |Ng·w| there; 1 at the background.
    pub cosine: f64,
    /// Per solid angle, of a connection from the last node to that point.
    pub connection: f64,
    /// Per area, of a light path's start there: P p_A; 0 on the inside of a light, and for the background.
    pub start: f64,
    /// Per solid angle, of the direction in which a light path leaves the point, over its cosine there.
    pub leaving: f64,
}

/// A path from the eye to a light, with the quantities that all techniques need of its vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// From the eye on.
    pub nodes: Vec<Node>,
    /// p_c/(t² n_l) at the first node, and n_l.
    pub importance: f64,
    pub light_paths: f64,
    pub source: Source,
}

impl Chain {
    /// The path that leaves the `eye`, or that point of its lens, and scatters at `bounces`, at least one.
    pub fn new<F: Real>(
        world: &World<F>,
        settings: &Settings,
        eye: Vec3<F>,
        bounces: &[Bounce<F>],
        end: End<F>,
    ) -> Option<Self> {
        let (first, last) = (bounces.first()?, bounces.last()?);
        let mut before = eye;
        let nodes = bounces.iter().map(|b| {
            let distance = length3(b.v.p - before).f64();
            before = b.v.p;
            node(settings, b, distance)
        });
        let nodes = nodes.collect();
        Some(Self {
            nodes,
            importance: eye_importance(&world.camera, first.v.p - eye).f64(),
            light_paths: f64::from(world.width * world.camera.height),
            source: source(world, settings, last, end),
        })
    }
}

fn source<F: Real>(world: &World<F>, settings: &Settings, last: &Bounce<F>, end: End<F>) -> Source {
    let (p, n) = (last.v.p, pick_normal(world, settings, &last.v));
    let expected = |light| pick_probability(world, settings, light, p, n);
    match end {
        End::Background { light } => Source {
            distance: 1.0,
            cosine: 1.0,
            connection: (expected(light) * world.outside_seen(light, last.wi).pdf).f64(),
            start: 0.0,
            leaving: 0.0,
        },
        End::Point {
            light,
            prim,
            p: q,
            cosine,
        } => {
            let distance = length3(q - p);
            let pdf = world.light_pdf(light, p, prim, cosine, distance);
            let start = world.light_pmf(light) * world.emission_pdf(light, p, prim, last.wi);
            Source {
                distance: distance.f64(),
                cosine: cosine.f64(),
                connection: (expected(light) * pdf).f64(),
                start: start.f64(),
                leaving: aimed_density(&world.aims, q, -last.wi, cosine).f64(),
            }
        }
    }
}

fn node<F: Real>(settings: &Settings, b: &Bounce<F>, distance: f64) -> Node {
    let density = |from, to| match b.delta {
        true => 1.0,
        false => reverse_pdf(settings, &b.v, from, to).f64(),
    };
    Node {
        to_eye: dot3(b.wo, b.v.ng).abs().f64(),
        to_light: dot3(b.wi, b.v.ng).abs().f64(),
        distance,
        onwards: density(b.wo, b.wi),
        back: density(b.wi, b.wo),
        delta: b.delta,
    }
}
