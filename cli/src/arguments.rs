//! The command line: all commands, and which of them was typed.

use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction, Args, CommandFactory, FromArgMatches, Parser, Subcommand};

use super::init::InitArguments;
use super::merge::MergeArguments;
use super::render::RenderArguments;
use crate::export::command::ExportArguments;
use crate::farm::command::FarmArguments;
use vkpt_lab::check::command::CheckArguments;
use vkpt_lab::cli::destination::all_written;
use vkpt_lab::cli::exit::{Ending, Failure};
use vkpt_lab::cli::numbers::negative;
use vkpt_lab::cli::streams::print_help;
use vkpt_lab::compare::command::CompareArguments;
use vkpt_lab::converge::command::ConvergeArguments;
use vkpt_lab::doctor::command::DoctorArguments;
use vkpt_lab::explain::command::ExplainArguments;
use vkpt_lab::suite::command::TestArguments;

const DEVICES_HELP: &str = "\
Exit codes:
    0  a Vulkan device can render
    4  no Vulkan device can render; the reference renderer always can
    5  stdout could not be written

Examples:
  vkpt devices     list the devices; --device takes the first column";

/// The essentials; `vkpt render --help` has the rest.
const AFTER_HELP: &str = "\
Examples:
  vkpt init                             write scene.txt, a first scene
  vkpt scene.txt                        render it to scene.png and scene.exr
  vkpt scene.txt --time 60 -o a.png     render for one minute
  vkpt scene.txt --target-error 1e-3    until the relMSE is below 1e-3

See `vkpt render --help` for all options and exit codes, and
`vkpt COMMAND --help` for those of a command.";

const AFTER_RENDER_HELP: &str = "\
Exit codes:
    0  the pictures are written
    1  rendering failed (device error, or a failed check of the samples), or denoising failed: the
       noisy pictures are written
    2  the command line is wrong
    3  the scene or one of its meshes is wrong; nothing was written
    4  no Vulkan device, or none that matches --device
    5  a file or stdout could not be written
    6  not enough memory, or a driver aborted
    7  the device failed twice; the pictures and the .vkpt file contain the samples done by then
  130  interrupted by ctrl-c or on the --view page; the pictures contain the samples done by then
  143  interrupted by SIGTERM; 129 by SIGHUP

Examples:
  vkpt scene.txt --spp 256 -o a.png -o a.exr       two pictures, 256 samples per pixel
  vkpt scene.txt --crop 100,100,164,164            a detail, the same pixels as in the full picture
  vkpt scene.txt --spp 4096 --resume               continue an interrupted run
  vkpt scene.txt --device cpu-f64                  the reference renderer; needs no Vulkan
  vkpt scene.txt --aov albedo,depth,stderr         also write layers and standard errors
  vkpt scene.txt --json report.json --quiet        for scripts";

/// The options that `vkpt --help` shows, as briefly as it can.
const SHOWN: [(&str, &str); 6] = [
    ("scene", "The scene file, text or glTF, or - for stdin"),
    ("output", ".png, .hdr or .exr; may be repeated"),
    ("spp", "Samples per pixel [default: 64]"),
    ("time", "Stop after this many seconds"),
    ("target_error", "Stop once the relMSE is below this"),
    ("device", "A Vulkan device, cpu-f32 or cpu-f64"),
];

/// A headless path tracer on Vulkan: a scene file goes in, pictures come out
#[derive(Parser, Debug)]
#[command(
    name = "vkpt",
    version,
    args_conflicts_with_subcommands = true,
    subcommand_negates_reqs = true
)]
#[command(subcommand_value_name = "COMMAND", disable_help_subcommand = true)]
pub struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    render: RenderArguments,
}

#[derive(Subcommand, Debug)]
enum Command {
    /// Write a first scene, whose comments explain the language
    Init(InitArguments),
    /// Render a scene to pictures (the default command)
    Render(Box<RenderArguments>),
    /// List the devices, and why some cannot render
    #[command(after_help = DEVICES_HELP)]
    Devices,
    /// Merge parts of a picture rendered with --samples
    Merge(Box<MergeArguments>),
    /// Measure how fast a scene converges under various settings
    Converge(Box<ConvergeArguments>),
    /// Compare pictures, or renderers path by path
    Compare(Box<CompareArguments>),
    /// Render a folder of scenes and compare with expected pictures
    Test(Box<TestArguments>),
    /// Render stiff and extreme cases and check their error bounds
    Check(Box<CheckArguments>),
    /// Test whether a Vulkan device renders correctly
    Doctor(DoctorArguments),
    /// Print which parts the kernel of a scene has, and why
    Explain(Box<ExplainArguments>),
    /// Write a scene for another renderer
    Export(Box<ExportArguments>),
    /// Write Slurm scripts that render on many machines
    Farm(Box<FarmArguments>),
}

/// The task that the command line requests.
#[derive(Debug)]
pub enum Task {
    Render(Box<RenderArguments>),
    Merge(Box<MergeArguments>),
    Compare(Box<CompareArguments>),
    Converge(Box<ConvergeArguments>),
    Check(Box<CheckArguments>),
    Test(Box<TestArguments>),
    Explain(Box<ExplainArguments>),
    Export(Box<ExportArguments>),
    Farm(Box<FarmArguments>),
    Doctor(DoctorArguments),
    Devices,
    Init(InitArguments),
    /// Help or version, as clap formats it.
    Help(clap::Error),
}

/// Reads a command line, the program's name first.
pub fn task(words: &[OsString]) -> Result<Task, Failure> {
    let first_page = command_line().mut_args(shown);
    let matches = match first_page.try_get_matches_from(words) {
        Ok(matches) => matches,
        Err(wrong) if wrong.use_stderr() => return Err(mistake(wrong)),
        Err(help) => return Ok(Task::Help(help)),
    };
    if let Some(("compare", matches)) = matches.subcommand()
        && let Some(message) = CompareArguments::misplaced(matches)
    {
        return Err(Failure::Usage(message));
    }
    let Arguments { command, render } =
        Arguments::from_arg_matches(&matches).map_err(Failure::CommandLine)?;
    Ok(match command {
        None => Task::Render(Box::new(render)),
        Some(Command::Render(arguments)) => Task::Render(arguments),
        Some(Command::Devices) => Task::Devices,
        Some(Command::Init(arguments)) => Task::Init(arguments),
        Some(Command::Converge(arguments)) => Task::Converge(arguments),
        Some(Command::Merge(arguments)) => Task::Merge(arguments),
        Some(Command::Compare(arguments)) => Task::Compare(arguments),
        Some(Command::Check(arguments)) => Task::Check(arguments),
        Some(Command::Test(arguments)) => Task::Test(arguments),
        Some(Command::Doctor(arguments)) => Task::Doctor(arguments),
        Some(Command::Explain(arguments)) => Task::Explain(arguments),
        Some(Command::Export(arguments)) => Task::Export(arguments),
        Some(Command::Farm(arguments)) => Task::Farm(arguments),
    })
}

/// clap's error in words that fit: it takes a second scene for a subcommand, and advises `-- --flag` for any unknown flag.
fn mistake(mut wrong: clap::Error) -> Failure {
    let second = match wrong.get(ContextKind::InvalidSubcommand) {
        Some(ContextValue::String(word)) if wrong.kind() == ErrorKind::ArgumentConflict => word,
        _ => {
            let advice = wrong.remove(ContextKind::Suggested);
            if let Some(ContextValue::StyledStrs(mut all)) = advice {
                all.retain(|tip| !tip.to_string().contains("as a value, use"));
                if !all.is_empty() {
                    wrong.insert(ContextKind::Suggested, ContextValue::StyledStrs(all));
                }
            }
            return Failure::CommandLine(wrong);
        }
    };
    Failure::Usage(format!(
        "unexpected argument '{second}': vkpt renders one scene, and a command such as `vkpt compare` comes first"
    ))
}

/// The arguments `A` of a command from words for them, for a program that calls.
pub fn parsed<A: Args>(words: impl IntoIterator<Item = OsString>) -> Result<A, Failure> {
    let matches = of::<A>().try_get_matches_from(words);
    let parsed = matches.and_then(|matches| A::from_arg_matches(&matches));
    parsed.map_err(Failure::CommandLine)
}

/// The flags of a command by their long names, and whether each is a switch, which takes no value.
pub fn flags<A: Args>() -> Vec<(String, bool)> {
    let command = of::<A>();
    let flags = command.get_arguments().filter_map(|flag| {
        let is_switch = matches!(flag.get_action(), ArgAction::SetTrue);
        Some((flag.get_long()?.to_owned(), is_switch))
    });
    flags.collect()
}

fn of<A: Args>() -> clap::Command {
    let none = clap::Command::new("vkpt").no_binary_name(true);
    finished(A::augment_args(none.disable_help_flag(true)))
}

/// Prints help or version.
pub fn help(text: &clap::Error) -> Result<Ending, Failure> {
    all_written([print_help(text)])?;
    Ok(Ending::Complete)
}

/// All commands with all flags.
pub fn command_line() -> clap::Command {
    let command = Arguments::command()
        .after_help(AFTER_HELP)
        .mut_subcommand("render", |render| render.after_help(AFTER_RENDER_HELP));
    with_usage(finished(command), "")
}

/// An option of the first page of help: brief, or hidden.
fn shown(arg: Arg) -> Arg {
    match SHOWN.iter().find(|(id, _)| arg.get_id() == id) {
        Some((_, help)) => arg.help(*help).help_heading(None),
        None => arg.hide(true),
    }
}

/// The command, and those in it, with flags that take negative numbers, and lines of readable length.
fn finished(command: clap::Command) -> clap::Command {
    command
        .mut_args(negative)
        .max_term_width(100)
        .mut_subcommands(finished)
}

/// The command, whose name comes after `before`, and those in it, with the same usage in errors as in help. In errors,
/// clap would show only the arguments that were given.
fn with_usage(command: clap::Command, before: &str) -> clap::Command {
    // Printing a usage ends the construction of a command.
    let usage = command.clone().render_usage().to_string();
    let usage = usage.trim_start_matches("Usage: ");
    let path = format!("{before}{} ", command.get_name());
    // A usage that the command itself overrides is complete.
    let missing = if usage.starts_with(&path) { "" } else { before };
    let usage = format!("{missing}{usage}");
    let command = command.override_usage(usage);
    command.mut_subcommands(|command| with_usage(command, &path))
}
