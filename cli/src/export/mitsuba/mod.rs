//! Mitsuba 3: XML, with meshes as PLY files. Both programs converge to the same picture (measured: `benches/peers/`).

mod camera;
mod document;
mod integrator;
mod reason;
mod shape;
mod surface;

pub use document::Node;
pub use reason::{Reason, setting};

use super::remark::{Remark, gathered};
use super::{Export, Subject, Text, mesh, place};
use vkpt::prepared::Prepared;
use vkpt::scene::Scene;

/// The scene for Mitsuba 3. [`setting`] must have accepted the model.
///
/// # Errors
/// Every feature without an equivalent in Mitsuba, each reason once, in file order.
pub fn export(subject: &Subject) -> Result<Export, Vec<Remark<Reason>>> {
    let mut refusals = places(subject.prepared);
    if subject.scene.surroundings.is_some() {
        let line = subject.scene.background_line;
        refusals.push(Remark::new(line, Reason::Surroundings));
    }
    let surfaces = surface::nodes(subject.prepared, &mut refusals);
    let shapes = shape::nodes(subject, &mut refusals);
    if !refusals.is_empty() {
        return Err(gathered(refusals));
    }
    let root = Node::new("scene")
        .attribute("version", "3.9.1")
        .with(integrator::node(subject))
        .with(camera::node(subject))
        .with_all(background(subject.scene))
        .with_all(surfaces)
        .with_all(shapes);
    Ok(Export {
        text: Text::Xml(root),
        beside: mesh::files(subject),
        warnings: Vec::new(),
        note: None,
    })
}

/// Refusals because of the geometry.
fn places(prepared: &Prepared) -> Vec<Remark<Reason>> {
    let about_eye = place::lights_about_eye(prepared);
    let about_eye = about_eye.map(|line| Remark::new(line, Reason::EyeInLight));
    let coincident = place::coincident(prepared);
    let coincident = coincident.map(|(line, other)| Remark::new(line, Reason::Coincident(other)));
    about_eye.chain(coincident).collect()
}

fn background(scene: &Scene) -> Option<Node> {
    let shines = scene.background.max_element() > 0.0;
    shines.then(|| Node::plugin("emitter", "constant").rgb("radiance", scene.background))
}
