//! Scenes in pbrt's format: legal statements, each value as computed by hand from the scene; scenes without an equivalent are
//! refused.

mod camera;
mod format;
mod refusals;
mod shapes;
mod surfaces;

use format::{Statement, read};
use vkpt::settings::Settings;
use vkpt_cli::export::pbrt::{Reason, export as pbrt};
use vkpt_cli::export::{Beside, Remark};

use super::{exported, models_without_an_equal, refusals, same, written};

/// The files of an export.
struct Exported {
    statements: Vec<Statement>,
    meshes: Vec<Beside>,
    warnings: Vec<Remark<String>>,
}

fn export_by(text: &str, settings: &Settings) -> Result<Exported, Vec<Remark<Reason>>> {
    let export = exported(text, settings, pbrt)?;
    let text = String::from_utf8(written(&export)).expect("UTF-8");
    Ok(Exported {
        statements: read(&text).unwrap_or_else(|wrong| panic!("{wrong} in\n{text}")),
        meshes: export.beside,
        warnings: export.warnings,
    })
}

fn export(text: &str) -> Exported {
    export_by(text, &Settings::default()).expect("nothing is refused")
}

/// Each refused line and why.
fn refused(text: &str) -> Vec<(usize, Reason)> {
    refusals(export_by(text, &Settings::default()))
}

impl Exported {
    /// The statements of a directive.
    fn all(&self, directive: &str) -> Vec<&Statement> {
        let all = self.statements.iter();
        all.filter(|s| s.directive == directive).collect()
    }

    /// The one statement of a directive.
    fn only(&self, directive: &str) -> &Statement {
        match self.all(directive)[..] {
            [only] => only,
            ref all => panic!("{} of {directive}", all.len()),
        }
    }
}

fn check(statement: &Statement, parameter: &str, expected: &[f64]) {
    same(&statement.numbers_of(parameter), expected, parameter);
}
