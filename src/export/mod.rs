//! A scene for another renderer: XML as Mitsuba 3 reads it, and its meshes as PLY files. What that program converges to is
//! the same picture (measured: `benches/peers/`). What it has no equal of is refused, by line.

mod camera;
mod document;
mod integrator;
mod mesh;
mod place;
mod refusal;
mod shape;
mod surface;

use std::io::{self, Write};

use document::Node;
pub use mesh::MeshFile;
pub use refusal::{Reason, Refusal, setting};

use crate::prepared::Prepared;
use crate::scene::Scene;
use crate::settings::Model;

/// What is to be said in another renderer's words.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    pub scene: &'a Scene,
    /// The same, by the settings and at the size of the picture.
    pub prepared: &'a Prepared,
    pub model: &'a Model,
    /// First column and row, then those behind the last, from the top left.
    pub crop: Option<[u32; 4]>,
    /// What the names of mesh files begin with.
    pub stem: &'a str,
}

/// What the other renderer reads.
#[derive(Clone, Debug)]
pub struct Export {
    root: Node,
    /// To stand beside the XML, which has their names.
    pub meshes: Vec<MeshFile>,
}

/// The scene in Mitsuba 3's words. [`setting`] has nothing against the model.
///
/// # Errors
/// All that Mitsuba has no equal of, each reason once, in the order of the file.
pub fn mitsuba(subject: &Subject) -> Result<Export, Vec<Refusal>> {
    let mut refusals = place::refusals(subject.prepared);
    if subject.scene.surroundings.is_some() {
        let line = subject.scene.background_line;
        refusals.push(Refusal::new(line, Reason::Surroundings));
    }
    let surfaces = surface::nodes(subject.prepared, &mut refusals);
    let shapes = shape::nodes(subject, &mut refusals);
    if !refusals.is_empty() {
        return Err(refusal::gathered(refusals));
    }
    let root = Node::new("scene")
        .attribute("version", "3.9.1")
        .with(integrator::node(subject))
        .with(camera::node(subject))
        .with_all(background(subject.scene))
        .with_all(surfaces)
        .with_all(shapes);
    Ok(Export {
        root,
        meshes: mesh::files(subject),
    })
}

impl Export {
    /// Writes the XML.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        self.root.write(out)
    }
}

fn background(scene: &Scene) -> Option<Node> {
    let shines = scene.background.max_element() > 0.0;
    shines.then(|| Node::plugin("emitter", "constant").rgb("radiance", scene.background))
}
