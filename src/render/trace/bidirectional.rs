//! Events of both paths of a bidirectional sample, each connection with every technique for its path.

use super::chain::{Bounce, Chain, End};
use super::event::{Event, Names, lobe_name, xyz};
use super::paths::{Paths, Step};
use super::techniques::Technique;
use crate::prepared::NONE;
use crate::reference::bsdf::LOBE_NONE;
use crate::reference::integrator::bidirectional::joint::Joint;
use crate::reference::integrator::bidirectional::record::{Far, Recorder};
use crate::reference::integrator::light::begin::LightStart;
use crate::reference::math::{Real, Vec3, dot3, length3};
use crate::reference::path::Subpath;
use crate::reference::path::blocks::Origin;
use crate::reference::path::vertex::Vertex;
use crate::reference::world::World;
use crate::settings::Settings;

/// The events so far.
pub struct Events<'a, F> {
    world: &'a World<F>,
    settings: &'a Settings,
    names: Names<'a>,
    events: Vec<Event>,
    /// Index of the last vertex among them.
    vertex: usize,
    paths: Paths<F>,
}

impl<'a, F: Real> Events<'a, F> {
    /// No events yet.
    pub fn new(world: &'a World<F>, settings: &'a Settings, names: Names<'a>) -> Self {
        Self {
            world,
            settings,
            names,
            events: Vec::new(),
            vertex: 0,
            paths: Paths::new(world.camera.eye),
        }
    }

    /// The events; the eye path's radiance is `radiance`.
    pub fn finish(mut self, radiance: Vec3<F>) -> Vec<Event> {
        self.push(
            "the eye path ends".to_owned(),
            vec![("radiance", xyz(radiance))],
        );
        self.events
    }

    fn push(&mut self, what: String, numbers: Vec<(&'static str, Vec<f64>)>) {
        self.events.push(Event {
            what,
            numbers,
            rows: Vec::new(),
        });
    }

    /// Light found by `light` and `eye` vertices of the two paths.
    fn found(
        &mut self,
        [light, eye]: [u32; 2],
        to: &str,
        arrived: Option<Vec3<F>>,
        path: Whole<F>,
    ) {
        let how = if arrived.is_some() {
            ""
        } else {
            ", is blocked"
        };
        let brought = xyz(arrived.unwrap_or(Vec3::zero()));
        let rows = match arrived {
            Some(_) => self.rows([light, eye], path),
            None => Vec::new(),
        };
        self.events.push(Event {
            what: format!("s={light} t={eye}: {to}{how}"),
            numbers: vec![("light", brought)],
            rows,
        });
    }

    /// Density and weight of each way to find the path.
    fn rows(&self, [light, eye]: [u32; 2], (point, bounces, end): Whole<F>) -> Vec<String> {
        let Some(chain) = Chain::new(self.world, self.settings, point, &bounces, end) else {
            return Vec::new();
        };
        let here = (light as usize, eye as usize);
        let row = |t: Technique| {
            let mark = if (t.light, t.eye) == here { " *" } else { "" };
            let (s, e) = (t.light, t.eye);
            format!(
                "s={s:<2} t={e:<2} density {:>14.7e}  weight {:.7}{mark}",
                t.density, t.weight
            )
        };
        chain.techniques().into_iter().map(row).collect()
    }
}

/// Where a path leaves the eye, every vertex that scatters, and where it ends.
type Whole<F> = (Vec3<F>, Vec<Bounce<F>>, End<F>);

impl<F: Real> Recorder<F> for Events<'_, F> {
    fn start(&mut self, start: &LightStart<F>, path: &Subpath<F>, power: Vec3<F>) {
        self.paths.start = Some(*start);
        let on = self.names.of(start.shape);
        let numbers = vec![
            ("point", self.names.place(start.point.p.f64())),
            ("direction", xyz(path.ray.d)),
            ("power", xyz(power)),
        ];
        self.push(format!("the light path leaves {on}"), numbers);
    }

    fn looks(&mut self, path: &Subpath<F>) {
        self.paths.eye_point = path.ray.o;
        if self.world.lens.is_some() {
            let numbers = vec![
                ("point", self.names.place(path.ray.o.f64())),
                ("direction", xyz(path.ray.d)),
            ];
            self.push("the eye path leaves the lens".to_owned(), numbers);
        }
    }

    fn hit(&mut self, from: Origin, x: &Joint<F>) {
        let (path, carried) = match from {
            Origin::Light => ("light", "power"),
            Origin::Eye => ("eye", "throughput"),
        };
        let Vertex { shape, prim, p, .. } = x.v;
        let on = self.names.of(shape);
        self.vertex = self.events.len();
        let numbers = vec![
            ("point", self.names.place(p.f64())),
            (carried, xyz(x.carried)),
        ];
        let what = format!("{path} vertex {} on {on}, primitive {prim}", x.count);
        self.push(what, numbers);
        self.paths.steps(from).push(Step {
            joint: *x,
            delta: false,
        });
    }

    fn emission(&mut self, on: Option<&Joint<F>>, path: &Subpath<F>, seen: Vec3<F>) {
        if seen == Vec3::zero() {
            return;
        }
        let light = match on {
            None => self.world.background_light,
            Some(x) => self.world.light_of(x.v.shape),
        };
        let Some(light) = light else { return };
        let end = match on {
            None => End::Background { light },
            Some(x) => End::Point {
                light,
                prim: x.v.prim,
                p: x.v.p,
                cosine: dot3(x.wo, x.v.ng).abs(),
            },
        };
        // The light itself is the last vertex that was hit.
        let count = self.paths.eye.len() - usize::from(on.is_some());
        let bounces = self.paths.eye_bounces(count, path.ray.d);
        let shape = on.map_or(NONE, |x| x.v.shape);
        let to = format!("the eye path reaches {}", self.names.of(shape));
        let whole = (self.paths.eye_point, bounces, end);
        self.found([0, path.bounce + 2], &to, Some(seen), whole);
    }

    fn connection(&mut self, far: Far<F>, arrived: Option<Vec3<F>>) {
        match far {
            Far::Eye { pixel, point } => self.splat(pixel, point, arrived),
            Far::Light(candidate) => {
                let Some(x) = self.paths.eye.last().map(|s| s.joint) else {
                    return;
                };
                let (light, l) = (candidate.light, candidate.point);
                let end = match l.distance < F::zero() {
                    true => End::Background { light },
                    false => End::Point {
                        light,
                        prim: l.prim,
                        p: x.v.p + l.wi * l.distance,
                        cosine: l.cosine,
                    },
                };
                let to = format!("to {}", self.names.of(self.world.lights[light].shape));
                let bounces = self.paths.eye_bounces(self.paths.eye.len(), l.wi);
                let whole = (self.paths.eye_point, bounces, end);
                self.found([1, x.count], &to, arrived, whole);
            }
            Far::Vertex(y) => self.joined(y, arrived),
        }
    }

    fn scattered(&mut self, from: Origin, path: &Subpath<F>, lobe: u32) {
        let delta = path.delta;
        if let Some(last) = self.paths.steps(from).last_mut() {
            last.delta = delta;
        }
        if let Some(event) = self.events.get_mut(self.vertex) {
            event.what += &format!(": {}", lobe_name(lobe));
            // It is meaningless for a delta lobe and for a path that ends.
            if lobe != LOBE_NONE && !delta {
                event.numbers.insert(1, ("pdf", vec![path.pdf.f64()]));
            }
        }
    }

    fn escape(&mut self, from: Origin, path: &Subpath<F>) {
        let which = match from {
            Origin::Light => "light",
            Origin::Eye => "eye",
        };
        let numbers = vec![("direction", xyz(path.ray.d))];
        self.push(format!("the {which} path leaves the scene"), numbers);
    }
}

impl<F: Real> Events<'_, F> {
    fn splat(&mut self, pixel: u32, point: Vec3<F>, arrived: Option<Vec3<F>>) {
        let (Some(end), Some(y)) = (self.paths.begun(), self.paths.light.last()) else {
            return;
        };
        let count = y.joint.count;
        let to = point - y.joint.v.p;
        let bounces = self
            .paths
            .light_bounces(self.paths.light.len() - 1, to / length3(to));
        let (column, row) = (pixel % self.world.width, pixel / self.world.width);
        let to = format!("a splat on pixel {column},{row}");
        self.found([count, 1], &to, arrived, (point, bounces, end));
    }

    fn joined(&mut self, y: &Joint<F>, arrived: Option<Vec3<F>>) {
        let (Some(end), Some(x)) = (self.paths.begun(), self.paths.eye.last().map(|s| s.joint))
        else {
            return;
        };
        let to = y.v.p - x.v.p;
        let wi = to / length3(to);
        let mut bounces = self.paths.eye_bounces(self.paths.eye.len(), wi);
        bounces.extend(self.paths.light_bounces(y.count as usize - 2, -wi));
        let to = format!("eye vertex {} to light vertex {}", x.count, y.count);
        let whole = (self.paths.eye_point, bounces, end);
        self.found([y.count, x.count], &to, arrived, whole);
    }
}
