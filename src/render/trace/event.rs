//! What happened to a path, as the reference tells it and as the device wrote it down.

use std::fmt::Write;

use crate::layout::Record;
use crate::reference::bsdf::{LOBE_DELTA, LOBE_DIFFUSE, LOBE_REFLECTION, LOBE_TRANSMISSION};
use crate::reference::math::{Real, Vec3};
use crate::reference::path::PathState;
use crate::reference::path::flight::ShadowRay;
use crate::reference::path::record::Recorder;
use crate::reference::path::vertex::Vertex;

/// What happened to a path, in words and numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    pub what: String,
    pub numbers: Vec<(&'static str, Vec<f64>)>,
}

/// Events of a path of the reference, in order.
pub struct Events(pub Vec<Event>);

impl<F: Real> Recorder<F> for Events {
    fn vertex(&mut self, s: &PathState<F>, v: &Vertex<F>, lobe: u32) {
        self.0.push(vertex(
            lobe,
            v.shape,
            v.prim,
            xyz(v.p),
            s.pdf.f64(),
            xyz(s.throughput),
            xyz(s.radiance),
        ));
    }

    fn connection(&mut self, s: &PathState<F>, c: &ShadowRay<F>, arrived: Option<Vec3<F>>) {
        self.0.push(connection(
            c.target.shape,
            xyz(c.ray.d),
            arrived.map(xyz),
            xyz(s.radiance),
        ));
    }

    fn escape(&mut self, s: &PathState<F>) {
        self.0
            .push(escape(xyz(s.ray.d), xyz(s.throughput), xyz(s.radiance)));
    }
}

/// `event` of a connection in `shaders/path/record/`; 1 is a vertex, anything else an escape.
const CONNECTION: u32 = 2;

/// The events that the device wrote down, in the order of the reference. The kernel flies the connection of a vertex a
/// turn later: it comes after its vertex there, whose radiance is then still without it.
pub fn in_order(records: &[Record]) -> Vec<Event> {
    let mut records = records.to_vec();
    for i in 1..records.len() {
        if records[i].event == CONNECTION {
            records[i - 1].radiance = records[i].radiance;
            records.swap(i - 1, i);
        }
    }
    records.iter().map(Event::from).collect()
}

impl From<&Record> for Event {
    fn from(r: &Record) -> Self {
        let wide = |v: [f32; 3]| v.map(f64::from).to_vec();
        let (p, throughput, radiance) = (wide(r.p), wide(r.throughput), wide(r.radiance));
        match r.event {
            1 => vertex(
                r.lobe,
                r.shape,
                r.prim,
                p,
                f64::from(r.pdf),
                throughput,
                radiance,
            ),
            CONNECTION => connection(r.shape, p, (r.lobe != 0).then_some(throughput), radiance),
            _ => escape(p, throughput, radiance),
        }
    }
}

fn xyz<F: Real>(v: Vec3<F>) -> Vec<f64> {
    v.f64().to_array().to_vec()
}

fn vertex(
    lobe: u32,
    shape: u32,
    prim: u32,
    p: Vec<f64>,
    pdf: f64,
    throughput: Vec<f64>,
    radiance: Vec<f64>,
) -> Event {
    let delta = if lobe >= LOBE_DELTA { "delta " } else { "" };
    let name = match lobe % LOBE_DELTA {
        LOBE_DIFFUSE => "diffuse",
        LOBE_REFLECTION => "reflection",
        LOBE_TRANSMISSION => "transmission",
        _ => "the path ends",
    };
    Event {
        what: format!("vertex on shape {shape}, primitive {prim}: {delta}{name}"),
        numbers: vec![
            ("point", p),
            ("pdf", vec![pdf]),
            ("throughput", throughput),
            ("radiance", radiance),
        ],
    }
}

fn connection(shape: u32, d: Vec<f64>, arrived: Option<Vec<f64>>, radiance: Vec<f64>) -> Event {
    let what = if arrived.is_some() {
        "arrives"
    } else {
        "is blocked"
    };
    let light = arrived.unwrap_or(vec![0.0; 3]);
    Event {
        what: format!("connection to shape {} {what}", shape as i32),
        numbers: vec![("direction", d), ("light", light), ("radiance", radiance)],
    }
}

fn escape(d: Vec<f64>, throughput: Vec<f64>, radiance: Vec<f64>) -> Event {
    Event {
        what: "leaves the scene".to_owned(),
        numbers: vec![
            ("direction", d),
            ("throughput", throughput),
            ("radiance", radiance),
        ],
    }
}

impl Event {
    /// Whether both are the same, numbers to the bit or within the relative `tolerance`.
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
                // A String can be written to without fail.
                let _ = write!(line, " {x:>14.7e}");
            }
            lines.push(line);
        }
        lines
    }
}
