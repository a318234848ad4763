//! The events of a path, as reported by the reference and as recorded by the device.

use std::fmt::Write;

use glam::DVec3;

use crate::layout::Record;
use crate::layout::constants::record::{RECORD_CONNECTION, RECORD_VERTEX};
use crate::prepared::Prepared;
use crate::reference::bsdf::{LOBE_DELTA, LOBE_DIFFUSE, LOBE_REFLECTION, LOBE_TRANSMISSION};
use crate::reference::integrator::path::PathState;
use crate::reference::integrator::path::record::Recorder;
use crate::reference::math::finite::is_finite3;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::trace::ShadowRay;
use crate::reference::path::vertex::Vertex;

/// An event of a path, in words and numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    pub what: String,
    pub numbers: Vec<(&'static str, Vec<f64>)>,
    /// Lines that explain it, and are not compared.
    pub rows: Vec<String>,
}

/// The scene, by which an event names the shape that was hit, and where in the file's coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Names<'a>(pub &'a Prepared);

impl Names<'_> {
    /// A shape by its index, its kind and the scene's line; `NONE` is the background.
    pub fn of(self, shape: u32) -> String {
        let Some(s) = self.0.shapes.get(shape as usize) else {
            return "the background".to_owned();
        };
        let kind = s.kind.description().name;
        format!("shape {shape} ({kind} of line {})", s.line)
    }

    pub fn place(self, p: DVec3) -> Vec<f64> {
        self.0.space.scene_point(p).to_array().to_vec()
    }
}

/// Events of a path of the reference, in order; the connection of a vertex comes after it.
pub struct Events<'a> {
    names: Names<'a>,
    events: Vec<Event>,
    /// The connection of the current vertex, and the radiance before it.
    pending: Option<(Event, Vec<f64>)>,
}

impl<'a> Events<'a> {
    /// No events yet.
    pub fn new(names: Names<'a>) -> Self {
        Self {
            names,
            events: Vec::new(),
            pending: None,
        }
    }

    /// The events.
    pub fn finish(self) -> Vec<Event> {
        self.events
    }
}

impl<F: Real> Recorder<F> for Events<'_> {
    fn vertex(&mut self, s: &PathState<F>, v: &Vertex<F>, lobe: u32) {
        let after = xyz(s.radiance);
        let (connection, before) = match self.pending.take() {
            Some((event, before)) => (Some(event), before),
            None => (None, after.clone()),
        };
        // a broken throughput is added to the radiance at the vertex itself
        let seen = if is_finite3(s.path.throughput) {
            before
        } else {
            after.clone()
        };
        let on = self.names.of(v.shape);
        let numbers = [
            self.names.place(v.p.f64()),
            vec![s.path.pdf.f64()],
            xyz(s.path.throughput),
            seen,
        ];
        self.events.push(vertex(lobe, &on, v.prim, numbers));
        if let Some(mut event) = connection {
            event.numbers.push(("radiance", after));
            self.events.push(event);
        }
    }

    fn connection(&mut self, s: &PathState<F>, c: &ShadowRay<F>, arrived: Option<Vec3<F>>) {
        let to = self.names.of(c.target.shape);
        let event = connection(&to, xyz(c.ray.d), arrived.map(xyz));
        self.pending = Some((event, xyz(s.radiance)));
    }

    fn escape(&mut self, s: &PathState<F>) {
        let numbers = [xyz(s.path.ray.d), xyz(s.path.throughput), xyz(s.radiance)];
        self.events.push(escape(numbers));
    }
}

/// A record of the device. It traces the connection of a vertex a turn later, so that one comes after the other.
pub fn event(names: Names, r: &Record) -> Event {
    let wide = |v: [f32; 3]| v.map(f64::from).to_vec();
    let (direction, throughput, radiance) = (wide(r.p), wide(r.throughput), wide(r.radiance));
    let on = names.of(r.shape);
    match r.event {
        RECORD_VERTEX => {
            let p = names.place(glam::Vec3::from(r.p).as_dvec3());
            let numbers = [p, vec![f64::from(r.pdf)], throughput, radiance];
            vertex(r.lobe, &on, r.prim, numbers)
        }
        RECORD_CONNECTION => {
            let mut event = connection(&on, direction, (r.lobe != 0).then_some(throughput));
            event.numbers.push(("radiance", radiance));
            event
        }
        _ => escape([direction, throughput, radiance]),
    }
}

pub fn xyz<F: Real>(v: Vec3<F>) -> Vec<f64> {
    v.f64().to_array().to_vec()
}

/// The name of a lobe at a vertex.
pub fn lobe_name(lobe: u32) -> String {
    let delta = if lobe >= LOBE_DELTA { "delta " } else { "" };
    let name = match lobe % LOBE_DELTA {
        LOBE_DIFFUSE => "diffuse",
        LOBE_REFLECTION => "reflection",
        LOBE_TRANSMISSION => "transmission",
        _ => "the path ends",
    };
    format!("{delta}{name}")
}

/// `numbers`: point, pdf, throughput, radiance.
fn vertex(lobe: u32, on: &str, prim: u32, numbers: [Vec<f64>; 4]) -> Event {
    let names = ["point", "pdf", "throughput", "radiance"];
    Event {
        what: format!("vertex on {on}, primitive {prim}: {}", lobe_name(lobe)),
        numbers: names.into_iter().zip(numbers).collect(),
        rows: Vec::new(),
    }
}

/// Without the radiance that the path then has.
fn connection(to: &str, d: Vec<f64>, arrived: Option<Vec<f64>>) -> Event {
    let what = if arrived.is_some() {
        "arrives"
    } else {
        "is blocked"
    };
    let light = arrived.unwrap_or(vec![0.0; 3]);
    Event {
        what: format!("connection to {to} {what}"),
        numbers: vec![("direction", d), ("light", light)],
        rows: Vec::new(),
    }
}

/// `numbers`: direction, throughput, radiance.
fn escape(numbers: [Vec<f64>; 3]) -> Event {
    let names = ["direction", "throughput", "radiance"];
    Event {
        what: "leaves the scene".to_owned(),
        numbers: names.into_iter().zip(numbers).collect(),
        rows: Vec::new(),
    }
}

impl Event {
    /// Whether both are equal, numbers to the bit or within the relative `tolerance`.
    pub fn agrees(&self, other: &Self, tolerance: f64) -> bool {
        let numbers = |e: &Self| {
            e.numbers
                .iter()
                .flat_map(|n| n.1.clone())
                .collect::<Vec<_>>()
        };
        let close = |(a, b): (f64, f64)| {
            a.to_bits() == b.to_bits()
                || (a - b).abs() <= tolerance * a.abs().max(b.abs()).max(1e-3)
        };
        self.what == other.what && numbers(self).into_iter().zip(numbers(other)).all(close)
    }

    pub fn lines(&self) -> Vec<String> {
        let mut lines = vec![self.what.clone()];
        for (name, values) in &self.numbers {
            let mut line = format!("    {name:<11}");
            for x in values {
                // Writing to a String cannot fail.
                let _ = write!(line, " {x:>14.7e}");
            }
            lines.push(line);
        }
        lines.extend(self.rows.iter().map(|row| format!("    {row}")));
        lines
    }
}
