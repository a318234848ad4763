//! `vkpt merge`: joins parts of a picture that were rendered separately.

mod arguments;
mod join;
mod order;
mod record;

use self::join::{Joined, join};
use self::order::{InOrder, in_order};
use crate::outputs::{Outputs, Written, write};
pub use arguments::MergeArguments;
use vkpt::film::Aov;
use vkpt::report::SettingsRecord;
use vkpt::report::names::Named;
use vkpt::settings::Sampler;
use vkpt::state::Header;
use vkpt_lab::cli::beside::Beside;
use vkpt_lab::cli::exit::{Ending, Failure, warn};
use vkpt_lab::cli::inputs::{Input, spare};
use vkpt_lab::cli::writable;

/// Reads the parts, joins them and writes the result, as a rendering does.
pub fn merge(arguments: &MergeArguments) -> Result<Ending, Failure> {
    let parts = in_order(arguments)?;
    let samples = parts.samples();
    let outputs = Outputs::new(&arguments.outputs, samples.len() as u32, || {
        Err(Failure::Usage(
            "-o FILE is missing: name the picture to write, or a .vkpt file for a larger part"
                .to_owned(),
        ))
    })?;
    if outputs.has_pictures() && samples.start > 0 {
        return Err(Failure::Pictures(vec![format!(
            "samples 0..{} are missing: a picture needs all samples from the first; write a larger part with -o FILE.vkpt",
            samples.start
        )]));
    }
    let _claims = writable::check(outputs.all())?;
    let read = |path| Input::new("a part", path);
    spare(&parts.paths().map(read).collect::<Vec<_>>(), outputs.all())?;
    check_stderr(arguments, &parts)?;
    if !parts.round_alike() {
        warn(
            "the parts were rendered by devices that round differently: the picture is as accurate as one rendering's, but not the same to the bit",
        );
    }
    let joined = join(&parts)?;
    leave(arguments, &outputs, &parts, &joined)
}

/// Standard errors of independent samples need moments, which not every part has.
fn check_stderr(arguments: &MergeArguments, parts: &InOrder) -> Result<(), Failure> {
    let asked = arguments.outputs.aov.contains(&Beside::Aov(Aov::Stderr));
    if let Some(layer) = arguments.outputs.aov.iter().find(|aov| aov.is_layer()) {
        return Err(Failure::Usage(format!(
            "--aov {} needs the scene, which parts do not contain: render it with vkpt SCENE",
            layer
        )));
    }
    let SettingsRecord { sampler, .. } = &parts.first().record.job.settings;
    match asked && *sampler == Sampler::Random.name() && !parts.keep_moments {
        true => Err(Failure::Usage(
            "--aov stderr with --sampler random needs parts that were rendered with --aov stderr"
                .to_owned(),
        )),
        false => Ok(()),
    }
}

fn leave(
    arguments: &MergeArguments,
    outputs: &Outputs,
    parts: &InOrder,
    joined: &Joined,
) -> Result<Ending, Failure> {
    let film = joined.part.picture();
    let spp = joined.part.samples();
    let asked = arguments.outputs.aov.contains(&Beside::Aov(Aov::Stderr)) && spp >= 2;
    let stderr = asked.then(|| joined.part.standard_errors());
    let header = Header {
        digest: parts.first().digest.clone(),
        rounding: parts.rounding(),
        record: record::record(parts, joined, &film),
    };
    write(
        outputs,
        Written {
            film: &film,
            channels: &[],
            stderr: stderr.as_ref().map(|film| (film, joined.part.freedom())),
            part: &joined.part,
            parts: &outputs.parts,
            header,
            denoised: None,
        },
    )
}
