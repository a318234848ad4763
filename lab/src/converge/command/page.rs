//! The contents of the page that are not in the record.

use super::arguments::ConvergeArguments;
use super::reference::References;
use super::variants::Variants;
use crate::cli::command;
use crate::cli::job::Request;
use crate::converge::Measured;
use crate::converge::report::{Convergence, Sheet, Shown};

/// Everything but the record.
pub struct Parts<'a> {
    scene: &'a str,
    command: String,
    exposure: f64,
    shown: Vec<Shown<'a>>,
}

pub fn parts<'a>(
    arguments: &'a ConvergeArguments,
    variants: &'a Variants,
    references: &'a References,
    measured: &'a Measured,
) -> Parts<'a> {
    let target = arguments.target();
    let curves = variants.jobs(arguments).into_iter().zip(&measured.curves);
    let shown = curves.map(|(job, curve)| {
        let request = Request {
            settings: job.settings,
            ..arguments.request()
        };
        Shown {
            curve,
            reference: &references.of(&job).reference,
            command: command::show(&request, &target),
        }
    });
    Parts {
        scene: &variants.text,
        command: command::typed(),
        exposure: arguments.exposure,
        shown: shown.collect(),
    }
}

impl<'a> Parts<'a> {
    pub fn sheet(self, record: &'a Convergence) -> Sheet<'a> {
        Sheet {
            record,
            scene: self.scene,
            command: self.command,
            exposure: self.exposure,
            shown: self.shown,
        }
    }
}
