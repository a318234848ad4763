//! The tree of lights, for picking one of many lights by its contribution (Conty Estevez & Kulla, Importance Sampling
//! of Many Lights with Adaptive Tree Splitting, HPG 2018; pbrt 4, section 12.6.3).

mod cone;
mod emitter;
mod split;

use glam::DVec3;

use super::placed::Placed;
use super::{Light, LightNode};
use crate::shape::Bounds;
use cone::Cone;
use emitter::Emitter;

/// A path from the root is stored in 32 bits.
const DEPTH: u32 = 32;
/// Radius of the ball that represents the background, in rendering space, whose shapes have size 1: every point is deep
/// inside.
const EVERYWHERE: f64 = 1e4;
/// Least power and radius: the numbers of nodes and their quotients stay in the range of f32.
const LEAST: f64 = 1e-15;
/// Bound on the effect of rounding to f32, for a scene of size 1.
const ROUNDING: f64 = 1e-6;

/// Its nodes, the root first, and the paths to the lights.
#[derive(Clone, Debug, Default)]
pub struct LightTree {
    pub nodes: Vec<LightNode>,
    /// For each light, its path from the root, lowest bit first: whether it is in the second of two nodes.
    pub trails: Vec<u32>,
}

impl LightTree {
    /// The tree of all `lights`, including everything outside with mean radiance `outside`; empty without lights.
    pub fn new(placed: &Placed, lights: &[Light], outside: DVec3) -> Self {
        let mut tree = Self {
            nodes: Vec::new(),
            trails: vec![0; lights.len()],
        };
        let mut emitters: Vec<Emitter> = (0..)
            .zip(lights)
            .filter_map(|(i, light)| Emitter::new(placed, light, i))
            .collect();
        let background = (0..).zip(lights).find(|(_, light)| light.kind.is_outside());
        // The background sends irradiance π L from every side.
        let sky = background.map_or(0.0, |_| std::f64::consts::PI * outside.element_sum());
        let total = sky + emitters.iter().map(|e| e.power).sum::<f64>();
        let share = |power: f64| (power / total).max(LEAST);
        emitters.iter_mut().for_each(|e| e.power = share(e.power));
        match background {
            Some((light, _)) => tree.add_background(light, share(sky), emitters),
            None if emitters.is_empty() => {}
            None => tree.add(emitters, 0, 0),
        }
        tree
    }

    /// Adds the background as the sibling of the tree of all other lights.
    fn add_background(&mut self, light: u32, irradiance: f64, others: Vec<Emitter>) {
        let sky = LightNode {
            power: irradiance * EVERYWHERE * EVERYWHERE,
            ..node(DVec3::ZERO, EVERYWHERE, Cone::ALL, 0.0, light, 1)
        };
        if others.is_empty() {
            self.nodes.push(sky);
            return;
        }
        // Only the shares of two siblings are evaluated, never that of the root.
        self.nodes.push(LightNode {
            child: 2,
            leaf: 0,
            ..sky
        });
        self.nodes.push(sky);
        self.trails[light as usize] = 0;
        self.add(others, 1, 1);
    }

    /// Adds the node over `emitters`, to which `trail` leads in `depth` steps.
    fn add(&mut self, emitters: Vec<Emitter>, trail: u32, depth: u32) {
        let i = self.nodes.len();
        let cone = emitters.iter().map(|e| e.cone).reduce(Cone::union);
        let cone = cone.unwrap_or(Cone::ALL);
        let power = emitters.iter().map(|e| e.power).sum();
        if let [e] = &emitters[..] {
            self.trails[e.light as usize] = trail;
            self.nodes
                .push(node(e.centre, e.radius, cone, power, e.light, 1));
            return;
        }
        let bounds = emitters.iter().map(|e| e.bounds).reduce(Bounds::union);
        let bounds = bounds.unwrap_or(Bounds::point(DVec3::ZERO));
        self.nodes
            .push(node(bounds.centre(), bounds.radius(), cone, power, 0, 0));
        let (first, second) = split::halves(emitters, DEPTH - 1 - depth);
        self.add(first, trail, depth + 1);
        self.nodes[i].child = self.nodes.len() as u32;
        self.add(second, trail | 1 << depth, depth + 1);
    }
}

/// A node, slightly enlarged, so that it remains a bound after rounding.
fn node(centre: DVec3, radius: f64, cone: Cone, power: f64, child: u32, leaf: u32) -> LightNode {
    let cos_o = (cone.cosine - ROUNDING).max(0.0);
    LightNode {
        centre,
        radius: (radius * (1.0 + ROUNDING) + ROUNDING * centre.length()).max(LEAST),
        axis: cone.axis,
        cos_o,
        power,
        sin_o: (1.0 - cos_o * cos_o).sqrt(),
        child,
        leaf,
    }
}
