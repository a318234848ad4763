//! One path, event by event, on two renderers side by side.

use std::fmt::{self, Display, Write};

use super::vulkan;
use super::{Job, RenderError, Target};
use crate::gpu::Device;
use crate::layout;
use crate::reference::bsdf::{LOBE_DELTA, LOBE_DIFFUSE, LOBE_REFLECTION, LOBE_TRANSMISSION};
use crate::reference::math::{Real, Vec3};
use crate::reference::path::flight::ShadowRay;
use crate::reference::path::record::Recorder;
use crate::reference::path::vertex::Vertex;
use crate::reference::path::{PathState, SampleId, trace_path};
use crate::reference::world::World;

/// Events of one path on the device asked for and on the reference in f32, or on both references.
pub struct Trace {
    names: [String; 2],
    paths: [Vec<Event>; 2],
    /// Relative difference that counts as one: 0 between two of f32.
    tolerance: f64,
}

/// What happened to a path, in words and numbers.
#[derive(Clone, Debug, PartialEq)]
struct Event {
    what: String,
    numbers: Vec<(&'static str, Vec<f64>)>,
}

/// The path of sample `index` of the pixel at column and row `pixel`.
///
/// # Errors
/// As those of a rendering.
pub fn trace(
    job: &Job,
    target: &Target,
    pixel: [u32; 2],
    index: u32,
) -> Result<Trace, RenderError> {
    let f32_path = reference::<f32>(job, pixel, index);
    let (other, name, tolerance) = match target {
        Target::Vulkan(selector) => {
            let device = Device::open(selector)?;
            let records = vulkan::records(job, &device, pixel, index)?;
            let events = records.iter().map(Event::from).collect();
            (events, device.info().name.clone(), 0.0)
        }
        Target::CpuF32 | Target::CpuF64 => (
            reference::<f64>(job, pixel, index),
            "cpu-f64".to_owned(),
            1e-3,
        ),
    };
    Ok(Trace {
        names: [name, "cpu-f32".to_owned()],
        paths: [other, f32_path],
        tolerance,
    })
}

fn reference<F: Real>(job: &Job, [column, row]: [u32; 2], sample: u32) -> Vec<Event> {
    let world = World::<F>::new(job.prepared);
    let id = SampleId {
        column,
        row,
        pixel: row * job.prepared.width + column,
        sample,
        seed: job.seed,
    };
    let mut events = Events(Vec::new());
    trace_path(&world, &job.settings, id, &mut events);
    events.0
}

struct Events(Vec<Event>);

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
        let light = arrived.unwrap_or(c.contribution);
        let visible = arrived.is_some();
        self.0.push(connection(
            visible,
            c.target.shape,
            xyz(c.ray.d),
            xyz(light),
            xyz(s.radiance),
        ));
    }

    fn escape(&mut self, s: &PathState<F>) {
        self.0
            .push(escape(xyz(s.ray.d), xyz(s.throughput), xyz(s.radiance)));
    }
}

impl From<&layout::Record> for Event {
    fn from(r: &layout::Record) -> Self {
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
            2 => connection(r.lobe != 0, r.shape, p, throughput, radiance),
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

fn connection(
    visible: bool,
    shape: u32,
    d: Vec<f64>,
    light: Vec<f64>,
    radiance: Vec<f64>,
) -> Event {
    let what = if visible { "arrives" } else { "is blocked" };
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

impl Trace {
    /// Number of the first event that is not the same on both sides.
    fn parting(&self) -> Option<usize> {
        let [a, b] = &self.paths;
        let differs = |i: &usize| match (a.get(*i), b.get(*i)) {
            (Some(a), Some(b)) => !a.agrees(b, self.tolerance),
            _ => true,
        };
        (0..a.len().max(b.len())).find(differs)
    }
}

impl Event {
    fn agrees(&self, other: &Self, tolerance: f64) -> bool {
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
}

impl Display for Trace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b] = &self.names;
        writeln!(f, "{:<60}  {b}", a)?;
        let parting = self.parting();
        for i in 0..self.paths[0].len().max(self.paths[1].len()) {
            let mark = if Some(i) == parting {
                "── the paths part here ──\n"
            } else {
                ""
            };
            f.write_str(mark)?;
            let sides = [0, 1].map(|k| self.paths[k].get(i).map_or(Vec::new(), Event::lines));
            for k in 0..sides[0].len().max(sides[1].len()) {
                let [left, right] = [0, 1].map(|s| sides[s].get(k).map_or("", String::as_str));
                writeln!(f, "{}", format!("{left:<60}  {right}").trim_end())?;
            }
        }
        match parting {
            None => f.write_str("the two paths are the same"),
            Some(i) => write!(f, "the two paths part at event {}", i + 1),
        }
    }
}

impl Event {
    fn lines(&self) -> Vec<String> {
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
