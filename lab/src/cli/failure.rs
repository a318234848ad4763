//! How a command ends: with what was asked for, or why not, and the exit code of each.

use vkpt::image::file::FileError;
use vkpt::prepared::PrepareError;
use vkpt::render::RenderError;
use vkpt::scene::Errors;

/// An end that left what was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    Complete,
    /// By ctrl-c or another signal.
    Interrupted,
    /// All but denoised pictures; why was said.
    Undenoised,
}

/// An end that did not.
#[derive(Debug)]
pub enum Failure {
    /// The command line is wrong in a way that clap does not find by itself.
    Usage(String),
    /// In a way that clap finds.
    CommandLine(clap::Error),
    Scene(Errors),
    Prepare(PrepareError),
    /// What a scene says and another renderer cannot.
    Untranslatable(Vec<String>),
    /// Warnings that `--strict` makes errors.
    Strict(Vec<String>),
    Render(RenderError),
    /// A scene does not fit into memory, or no threads can be made.
    Memory(String),
    /// What was compared is not the same.
    Comparison(Vec<String>),
    /// By the Vulkan loader or for want of a device.
    NoDevice(String),
    Files(Vec<FileError>),
    /// The device failed twice; where the samples done by then are.
    Lost {
        why: String,
        part: Option<String>,
    },
    /// Pictures that can't be read or compared.
    Pictures(Vec<String>),
    /// Jobs that a batch system did not take.
    Submission(String),
    /// A device that gets something wrong that pictures depend on.
    Unhealthy(String),
}

/// The exit code where memory or threads do not suffice.
pub const MEMORY: u8 = 6;

/// The exit code where the device failed twice.
const LOST: u8 = 7;

impl Failure {
    /// The program's exit code.
    pub fn code(&self) -> u8 {
        match self {
            Self::Render(error) if error.is_no_device() => 4,
            Self::Render(RenderError::Twice(_)) | Self::Lost { .. } => LOST,
            Self::Render(RenderError::Memory { .. }) | Self::Memory(_) => MEMORY,
            Self::Scene(errors) if errors.lacks_memory => MEMORY,
            Self::Render(_) | Self::Comparison(_) | Self::Submission(_) | Self::Unhealthy(_) => 1,
            Self::Usage(_) | Self::CommandLine(_) => 2,
            Self::Scene(_)
            | Self::Prepare(_)
            | Self::Untranslatable(_)
            | Self::Strict(_)
            | Self::Pictures(_) => 3,
            Self::NoDevice(_) => 4,
            Self::Files(_) => 5,
        }
    }

    /// Whether the scene or a picture is wrong, and not what renders it.
    pub fn is_of_input(&self) -> bool {
        match self {
            Self::Scene(errors) => !errors.lacks_memory,
            Self::Prepare(_) | Self::Strict(_) | Self::Pictures(_) | Self::Usage(_) => true,
            _ => false,
        }
    }

    /// What it is, a message each, as it is told after `error: `.
    pub fn messages(&self) -> Vec<String> {
        match self {
            Self::Scene(errors) => {
                let each = errors.diagnostics.iter().map(ToString::to_string);
                each.chain([errors.to_string()]).collect()
            }
            Self::CommandLine(wrong) => vec![sentence(wrong)],
            Self::Prepare(e) => vec![e.to_string()],
            Self::Render(e) => vec![e.to_string()],
            Self::Strict(warnings) => {
                let each = warnings.iter();
                each.map(|warning| format!("{warning} (--strict)"))
                    .collect()
            }
            Self::Usage(message)
            | Self::NoDevice(message)
            | Self::Memory(message)
            | Self::Submission(message) => vec![message.clone()],
            Self::Unhealthy(device) => vec![format!("{device} is not healthy")],
            Self::Lost { why, part } => {
                let resume = part.as_ref().map_or(String::new(), |part| {
                    format!(
                        "\n{part} has the samples done by then: --resume goes on from it. Of a CPU's driver, \
                         --resume --device cpu-f32 ends at the same picture, to the bit."
                    )
                });
                vec![format!("the device failed twice: {why}{resume}")]
            }
            Self::Comparison(messages)
            | Self::Untranslatable(messages)
            | Self::Pictures(messages) => messages.clone(),
            Self::Files(errors) => errors.iter().map(|e| format!("cannot write {e}")).collect(),
        }
    }
}

/// What is wrong with a command line, without the advice that clap adds for those who typed it.
fn sentence(wrong: &clap::Error) -> String {
    let text = wrong.to_string();
    let said = text.split("\n\n").next().unwrap_or(&text);
    said.trim_start_matches("error: ").trim_end().to_owned()
}
