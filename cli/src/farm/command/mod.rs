//! `vkpt farm slurm SCENE...`: scripts that render scenes in parts on many machines.

mod arguments;
mod folder;
mod submit;
mod typed;

use std::path::{Path, PathBuf};

use self::arguments::{SlurmArguments, System};
use self::folder::{Folder, text};
use crate::farm::{Farm, rounds, shares};
use crate::outputs::is_part;
pub use arguments::FarmArguments;
use vkpt::image::Format;
use vkpt::part::BLOCK;
use vkpt::shell::quoted;
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::exit::{Ending, Failure, note};
use vkpt_lab::cli::inputs::{Input, spare};
use vkpt_lab::cli::integrator;
use vkpt_lab::cli::job::Loaded;
use vkpt_lab::cli::source::Source;
use vkpt_lab::cli::streams::put;
use vkpt_lab::cli::writable;

/// The most tasks of a farm: Slurm keeps 10,000 jobs at a time, unless its MaxJobCount says otherwise.
const MOST_TASKS: u32 = 10_000;

/// Writes the scripts of every scene, and submits them if requested.
pub fn farm(arguments: &FarmArguments) -> Result<Ending, Failure> {
    let System::Slurm(arguments) = &arguments.system;
    check(arguments)?;
    let folders = arguments
        .scenes
        .iter()
        .map(|scene| folder(arguments, scene))
        .collect::<Result<Vec<_>, _>>()?;
    let twice = |i: &usize| folders[..*i].iter().any(|f| f.path == folders[*i].path);
    if let Some(i) = (1..folders.len()).find(twice) {
        return Err(Failure::Usage(format!(
            "two scenes would write their scripts to one folder, {}: rename one, or use a command with -o for each",
            folders[i].path.display()
        )));
    }
    if arguments.tasks > 1 && arguments.spp() / arguments.tasks < BLOCK {
        note(&format!(
            "parts of fewer than {BLOCK} samples are large, 12 bytes for each sample of a pixel: use fewer --tasks for smaller files"
        ));
    }
    for folder in &folders {
        folder.write()?;
        match arguments.submit {
            true => put(submit::submit(&folder.submit())?.as_bytes()),
            false => put(summary(folder).as_bytes()),
        }
        .map_err(|error| Failure::Files(vec![error]))?;
    }
    Ok(Ending::Complete)
}

/// The parts of a folder, and the command that submits them.
fn summary(folder: &Folder) -> String {
    let submit = quoted(&folder.submit().to_string_lossy());
    let parts = match &folder.farm.rounds[..] {
        [one] => format!("parts: {}", one.len()),
        rounds => format!(
            "parts: {} per round, at most {} rounds",
            rounds[0].len(),
            rounds.len()
        ),
    };
    format!("{parts}; submit them with: bash {submit}\n")
}

/// Checks the flags.
fn check(arguments: &SlurmArguments) -> Result<(), Failure> {
    let (tasks, spp) = (arguments.tasks, arguments.spp());
    let wrong = match () {
        () if arguments.scenes.contains(&Source::Stdin) => {
            "a scene from stdin cannot be rendered on other machines: write it to a file".to_owned()
        }
        () if arguments.scenes.len() > 1 && !arguments.output.is_empty() => {
            "-o names the pictures of one scene: omit it, or give one scene".to_owned()
        }
        () if tasks > MOST_TASKS => {
            format!(
                "--tasks must be at most {MOST_TASKS}, the default number of jobs that Slurm keeps"
            )
        }
        () if tasks > spp => format!(
            "--tasks {tasks} is more than --spp {spp}: each part needs at least one sample per pixel"
        ),
        () => return Ok(()),
    };
    Err(Failure::Usage(wrong))
}

/// The farm of one scene, which is read to find its errors.
fn folder(arguments: &SlurmArguments, scene: &Source) -> Result<Folder, Failure> {
    let pictures = pictures(arguments, scene)?;
    drop(writable::check(&pictures)?);
    let request = arguments.request(scene);
    integrator::check(&request.settings)?;
    let loaded = Loaded::new(&request)?;
    spare(&Input::of_scene(scene, &loaded.scene), &pictures)?;
    let files = pictures.iter().filter_map(Destination::path);
    let files = files.map(text).collect::<Result<Vec<_>, _>>()?;
    let path = PathBuf::from(&files[0]);
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let path = path.with_file_name(format!("{name}.farm"));
    let program = std::env::current_exe().unwrap_or_else(|_| "vkpt".into());
    let scene = text(Path::new(&scene.word()))?;
    let farm = Farm {
        name: name.into_owned(),
        folder: text(&path)?,
        vkpt: text(&program)?,
        rendering: [vec![scene], arguments.flags()].concat(),
        pictures: files,
        partition: arguments.partition.clone(),
        rounds: match arguments.in_rounds() {
            true => rounds(arguments.spp(), arguments.tasks),
            false => vec![shares(0..arguments.spp(), arguments.tasks)],
        },
        target_error: arguments.target_error,
        seconds: arguments.time,
    };
    Folder::new(path, farm)
}

/// The files of `-o`, else those named after the scene.
fn pictures(arguments: &SlurmArguments, scene: &Source) -> Result<Vec<Destination>, Failure> {
    if arguments.output.is_empty() {
        let stem = scene.stem().unwrap_or_default();
        let named = ["png", "exr"].map(|ending| {
            let mut name = stem.to_os_string();
            name.push(".");
            name.push(ending);
            Destination::File(name.into())
        });
        return Ok(named.into());
    }
    let is_picture = |to: &Destination| to.neighbour().and_then(Format::of).is_some();
    let all = &arguments.output;
    match all.iter().find(|to| !is_picture(to) && !is_part(to)) {
        Some(to) => Err(Failure::Usage(format!(
            "-o {to}: the ending must be .png, .hdr, .exr or .vkpt"
        ))),
        None => Ok(all.clone()),
    }
}
