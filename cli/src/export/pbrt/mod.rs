//! pbrt-v4: a text file, with meshes as PLY files. Where its model differs, the export warns (docs/exchange.md,
//! "pbrt").

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

/// The scene for pbrt-v4. [`setting`] must have accepted the model.
///
/// # Errors
/// Every feature without an equivalent in pbrt, each reason once, in file order.
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
