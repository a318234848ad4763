//! Whole paths from the eye to a light, with all that any way to find them asks of their vertices, in f64.

use vkpt::prepared::MaterialKind;
use vkpt::reference::camera::eye_sample;
use vkpt::reference::integrator::bidirectional::bend::reverse_pdf;
use vkpt::reference::integrator::path::begin_path;
use vkpt::reference::integrator::path::pick::{pick_normal, pick_probability};
use vkpt::reference::math::{Vec3, dot3};
use vkpt::reference::path::SampleId;
use vkpt::reference::path::blocks::Origin;
use vkpt::reference::path::extend::extend;
use vkpt::reference::path::trace::extend_ray;
use vkpt::reference::path::vertex::{Vertex, path_vertex};
use vkpt::reference::world::World;
use vkpt::settings::Settings;

/// A vertex that scatters.
pub struct Node {
    /// |Ng·w| to the vertex before and to the one after, counted from the eye.
    pub to_eye: f64,
    pub to_light: f64,
    /// To the vertex before.
    pub distance: f64,
    /// Densities per solid angle of going on to the light, and to the eye; 1 of a delta lobe.
    pub onwards: f64,
    pub back: f64,
    pub delta: bool,
}

/// A path that has found a light.
pub struct Chain {
    pub nodes: Vec<Node>,
    /// p_c/(t² n_l) at the first node, and n_l.
    pub importance: f64,
    pub light_paths: f64,
    /// From the last node to the light's point.
    pub distance: f64,
    /// |Ng·w| there.
    pub at_light: f64,
    /// Per solid angle, of a connection from the last node to that point.
    pub p_n: f64,
    /// P p_A; 0 on the inside of a light.
    pub p_a: f64,
}

/// The path of a sample, if it scatters at least once and then finds a light.
pub fn chain(world: &World<f64>, settings: &Settings, id: SampleId, pixels: u32) -> Option<Chain> {
    let mut path = begin_path(world, settings, id).path;
    let mut nodes: Vec<Node> = Vec::new();
    let (mut importance, mut rays) = (0.0, 0);
    let mut pick = Vec3::zero();
    loop {
        let origin = path.ray.o;
        let (hit, distance) = extend_ray(world, settings, &mut path, &mut rays);
        let v = path_vertex(world, settings, path.ray, hit?, distance, Vec3::one());
        let wo = -path.ray.d;
        if let Some(light) = world.light_of(v.shape) {
            let at_light = dot3(wo, v.ng).abs();
            let per_area = world.emission_pdf(light, origin, v.prim, path.ray.d);
            let expected = pick_probability(world, settings, light, origin, pick);
            return (!nodes.is_empty()).then(|| Chain {
                nodes,
                importance,
                light_paths: f64::from(pixels),
                distance,
                at_light,
                p_n: expected * world.light_pdf(light, origin, v.prim, at_light, distance),
                p_a: world.light_pmf(light) * per_area,
            });
        }
        if v.interaction.material.kind == MaterialKind::Black {
            return None;
        }
        if nodes.is_empty() {
            importance = eye_sample(&world.camera, v.p).importance;
        }
        pick = pick_normal(world, settings, &v);
        if !extend(settings, Origin::Eye, &mut path, &v, id).alive {
            return None;
        }
        nodes.push(node(
            settings, &v, wo, distance, path.ray.d, path.delta, path.pdf,
        ));
    }
}

fn node(
    settings: &Settings,
    v: &Vertex<f64>,
    wo: Vec3<f64>,
    distance: f64,
    wi: Vec3<f64>,
    delta: bool,
    pdf: f64,
) -> Node {
    let density = |from, to| match delta {
        true => 1.0,
        false => reverse_pdf(settings, v, from, to),
    };
    let onwards = density(wo, wi);
    if !delta {
        // The direction was drawn with the density that the weights see, but for the half vector's rounding error.
        assert!((onwards / pdf - 1.0).abs() < 1e-6, "{onwards} for {pdf}");
    }
    Node {
        to_eye: dot3(wo, v.ng).abs(),
        to_light: dot3(wi, v.ng).abs(),
        distance,
        onwards,
        back: density(wi, wo),
        delta,
    }
}

impl Chain {
    /// Density per area, of all vertices together, with which `eye` vertices from the eye and the rest from the light make this
    /// path; `None` where they cannot.
    pub fn density(&self, eye: usize) -> Option<f64> {
        let (n, k) = (&self.nodes, self.nodes.len());
        let light = k + 2 - eye;
        // Vertex j ≥ 1 is node j − 1; the last vertex, k + 1, lies on the light.
        let meets = |j: usize| n.get(j.wrapping_sub(1)).is_none_or(|node| !node.delta);
        let possible = match light {
            0 => true,
            1 => meets(k),
            _ => self.p_a > 0.0 && meets(eye - 1) && meets(eye),
        };
        if !possible {
            return None;
        }
        let distance = |j: usize| n.get(j - 1).map_or(self.distance, |node| node.distance);
        let from_eye = |j: usize| {
            let cosine = n.get(j - 1).map_or(self.at_light, |node| node.to_eye);
            let per_angle = match j {
                1 => self.importance * self.light_paths * distance(1).powi(2),
                _ => n[j - 2].onwards,
            };
            per_angle * cosine / distance(j).powi(2)
        };
        let from_light = |j: usize| {
            if j == k + 1 {
                return match light {
                    1 => self.p_n * self.at_light / self.distance.powi(2),
                    _ => self.p_a,
                };
            }
            let per_angle = match j == k {
                true => self.at_light / std::f64::consts::PI,
                false => n[j].back,
            };
            per_angle * n[j - 1].to_light / distance(j + 1).powi(2)
        };
        let paths = if eye == 1 { self.light_paths } else { 1.0 };
        let eyes: f64 = (1..eye).map(from_eye).product();
        let lights: f64 = (eye..k + 2).map(from_light).product();
        Some(eyes * lights * paths)
    }
}
