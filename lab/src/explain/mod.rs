//! The reasons for a kernel's parts: a pure function of the job, its plan and the text of its scene.

pub mod command;
mod figures;
mod lines;
mod member;
mod reasons;
pub mod report;
mod search;
mod setting;

use crate::explain::report::{Count, Explanation, Part};
use vkpt::features::Member;
use vkpt::kernel::{Composed, Spirv};
use vkpt::render::{Job, Plan};
use vkpt::settings::Settings;

/// The rendering to explain.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    pub job: &'a Job<'a>,
    pub plan: &'a Plan,
    /// The scene file's path as it was given.
    pub scene: &'a str,
    /// The scene file, line by line.
    pub text: &'a str,
    pub preset: Preset,
    /// Why the scene chose its integrator, if it did.
    pub auto: Option<&'a str>,
    /// The device whose limits the plan respects.
    pub device: &'a str,
}

/// The settings that apply without flags, and their source: `the default`, `--model handout`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preset {
    pub name: &'static str,
    pub settings: Settings,
}

/// A kernel's plan and its compiled code.
pub type Compiled<'a> = (&'a Plan, &'a [Spirv]);

/// The whole explanation; `full` is the kernel with every part, planned for the same job; `counts` are a driver's
/// statistics of `this`, if requested.
pub fn explain(
    subject: &Subject,
    this: &[Spirv],
    full: Compiled,
    counts: Option<Vec<Count>>,
) -> Explanation {
    let prepared = subject.job.prepared;
    Explanation {
        scene: subject.scene.to_owned(),
        size: [prepared.camera.width, prepared.camera.height],
        crop: subject.job.crop,
        device: subject.device.to_owned(),
        parts: parts(subject),
        kernels: [(subject.plan, this), full].map(figures::kernel),
        counts,
        buffers: figures::buffers(subject.plan),
        primitives: figures::primitives(prepared),
        hierarchy: subject.plan.hierarchy.as_ref().map(figures::hierarchy),
        memory: figures::memory(subject.job, subject.plan),
    }
}

/// All parts that a kernel of these settings may have: first those that the scene decides, then those of flags.
pub fn parts(subject: &Subject) -> Vec<Part> {
    let all = Member::all(&subject.job.settings);
    let (shapes, others): (Vec<Member>, Vec<Member>) = all
        .into_iter()
        .filter(|m| !matches!(m, Member::InBvh(_)))
        .partition(|m| matches!(m, Member::Shape(_)));
    let mut parts: Vec<Part> = shapes.iter().map(|&m| member::part(subject, m)).collect();
    parts.extend(search::parts(subject));
    parts.extend(others.iter().map(|&m| member::part(subject, m)));
    parts.extend(setting::parts(subject));
    parts
}

impl Subject<'_> {
    /// A line of the scene with blanks collapsed; empty for line 0.
    fn quote(&self, line: usize) -> String {
        let text = line.checked_sub(1).and_then(|i| self.text.lines().nth(i));
        let words: Vec<&str> = text.unwrap_or_default().split_whitespace().collect();
        words.join(" ")
    }

    /// Whether a file of `shaders/` is in the kernel.
    fn contains(&self, file: &str) -> bool {
        let mut files = self.plan.kernels.iter().flat_map(Composed::files);
        files.any(|name| name == file)
    }
}
