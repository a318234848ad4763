//! pbrt-v4: a text, and its meshes as PLY files. Where that program has another model of the same thing, the export says so
//! (docs/exchange.md, "pbrt").

mod camera;
mod difference;
mod reason;
mod shape;
mod statement;
mod surface;

pub use difference::Difference;
pub use reason::{Reason, setting};
use statement::{Statement, text};

use super::remark::{Remark, gathered};
use super::{Export, Subject, Text, mesh, place};

/// The scene in pbrt-v4's words. [`setting`] has nothing against the model.
///
/// # Errors
/// All that pbrt has no equal of, each reason once, in the order of the file.
pub fn export(subject: &Subject) -> Result<Export, Vec<Remark<Reason>>> {
    let coincident = place::coincident(subject.prepared);
    let coincident = coincident.map(|(line, other)| Remark::new(line, Reason::Coincident(other)));
    let mut refusals: Vec<_> = coincident.collect();
    if subject.scene.surroundings.is_some() {
        let line = subject.scene.background_line;
        refusals.push(Remark::new(line, Reason::Surroundings));
    }
    let surfaces = surface::statements(subject.prepared, &mut refusals);
    let shapes = shape::statements(subject, &mut refusals);
    if !refusals.is_empty() {
        return Err(gathered(refusals));
    }
    let mut all = surface::media(subject.prepared);
    all.extend(camera::statements(subject));
    all.push(Statement::new("WorldBegin"));
    all.extend(background(subject));
    all.extend(surfaces);
    all.extend(shapes);
    Ok(Export {
        text: Text::Bytes(text(&all).into_bytes()),
        beside: mesh::files(subject),
        warnings: difference::all(subject),
        note: None,
    })
}

fn background(subject: &Subject) -> Option<Statement> {
    let radiance = subject.scene.background;
    let shines = radiance.max_element() > 0.0;
    shines.then(|| {
        Statement::new("LightSource")
            .word("infinite")
            .rgb("L", radiance)
    })
}
