//! Binds the vertices of a primitive to joints (glTF 2.0, section 3.7.3.3, *Skinned Mesh Attributes*).

use glam::DAffine3;

use super::accessors::Accessors;
use super::document::Primitive;
use super::skin::Skin;

/// The joints of each vertex and their weights, which add up to 1.
pub(super) struct Binding<'a> {
    skin: &'a Skin,
    sets: Vec<Set>,
}

/// Four joints per vertex, and the weight of each.
struct Set {
    joints: Vec<[u32; 4]>,
    weights: Vec<[f64; 4]>,
}

impl<'a> Binding<'a> {
    /// Reads JOINTS_0 and WEIGHTS_0, JOINTS_1 … of a primitive. Errors are messages.
    pub(super) fn read(
        primitive: &Primitive,
        vertices: usize,
        skin: &'a Skin,
        accessors: &Accessors,
    ) -> Result<Self, String> {
        let set = |n: usize| {
            let names = [format!("JOINTS_{n}"), format!("WEIGHTS_{n}")];
            let [joints, weights] = names.each_ref().map(|name| primitive.attributes.get(name));
            let (joints, weights) = match (joints, weights) {
                (None, None) if n > 0 => return None,
                (Some(joints), Some(weights)) => (*joints, *weights),
                (joints, _) => {
                    let missing = &names[usize::from(joints.is_some())];
                    return Some(Err(format!(
                        "{} moves it, but it has no {missing}",
                        skin.label
                    )));
                }
            };
            Some(Set::read(joints, weights, vertices, accessors))
        };
        let sets = (0..).map_while(set).collect::<Result<_, _>>()?;
        let mut binding = Self { skin, sets };
        for vertex in 0..vertices {
            binding
                .normalise(vertex)
                .map_err(|what| format!("its vertex {vertex} {what}"))?;
        }
        Ok(binding)
    }

    /// Makes a vertex's weights add up to 1, as the format requires but for rounding. Hence integers may be normalised
    /// or not. A vertex without weights follows its first joint.
    fn normalise(&mut self, vertex: usize) -> Result<(), String> {
        let weights = || self.sets.iter().flat_map(|set| set.weights[vertex]);
        if let Some(bad) = weights().find(|w| !(w.is_finite() && *w >= 0.0)) {
            return Err(format!("has the weight {bad}"));
        }
        let sum: f64 = weights().sum();
        for (n, set) in self.sets.iter_mut().enumerate() {
            let weights = &mut set.weights[vertex];
            *weights = match (sum, n) {
                (0.0, 0) => [1.0, 0.0, 0.0, 0.0],
                (0.0, _) => [0.0; 4],
                _ => weights.map(|w| w / sum),
            };
        }
        let joints = self.skin.len();
        match self
            .joints(vertex)
            .find(|(joint, _)| *joint as usize >= joints)
        {
            Some((joint, _)) => {
                let skin = &self.skin.label;
                Err(format!(
                    "is bound to joint {joint}, but {skin} has {joints}"
                ))
            }
            None => Ok(()),
        }
    }

    /// The joints that move a vertex, and their weights.
    fn joints(&self, vertex: usize) -> impl Iterator<Item = (u32, f64)> {
        let all = self.sets.iter().flat_map(move |set| {
            let joints = set.joints[vertex].into_iter();
            joints.zip(set.weights[vertex])
        });
        all.filter(|(_, weight)| *weight != 0.0)
    }

    /// The transform of a vertex to the scene's space. The transform of the mesh's own node has no effect.
    pub(super) fn to_scene(&self, vertex: usize) -> DAffine3 {
        self.skin.blend(self.joints(vertex))
    }
}

impl Set {
    fn read(
        joints: usize,
        weights: usize,
        vertices: usize,
        accessors: &Accessors,
    ) -> Result<Self, String> {
        let set = Self {
            joints: accessors.indices(joints)?,
            weights: accessors.vectors(weights)?,
        };
        let counts = [("joints", set.joints.len()), ("weights", set.weights.len())];
        match counts.iter().find(|(_, count)| *count != vertices) {
            Some((what, count)) => Err(format!(
                "it has {what} for {count} vertices, but there are {vertices}"
            )),
            None => Ok(set),
        }
    }
}
