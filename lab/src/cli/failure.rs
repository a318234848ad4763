//! How a command ends: with its result or a failure, and the exit code of each.

use vkpt::image::file::FileError;
use vkpt::prepared::PrepareError;
use vkpt::render::RenderError;
use vkpt::scene::Errors;

/// An end with a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    Complete,
    /// By ctrl-c or another signal.
    Interrupted,
    /// Without denoised pictures; the reason has been printed.
    Undenoised,
}

/// An end without.
#[derive(Debug)]
pub enum Failure {
    /// The command line is wrong in a way that clap does not detect.
    Usage(String),
    /// In a way that clap detects.
    CommandLine(clap::Error),
    Scene(Errors),
    /// With the scene's name.
    Prepare(String, PrepareError),
    /// Parts of a scene that another renderer has no equivalent of.
    Untranslatable(Vec<String>),
    /// Warnings that `--strict` makes errors.
    Strict(Vec<String>),
    Render(RenderError),
    /// A scene does not fit into memory, or threads cannot be created.
    Memory(String),
    /// The compared things differ.
    Comparison(Vec<String>),
    /// The Vulkan loader fails, or no device is available.
    NoDevice(String),
    Files(Vec<FileError>),
    /// The device failed twice; `part` is the file with the samples done by then.
    Lost {
        why: String,
        part: Option<String>,
    },
    /// Pictures that can't be read or compared.
    Pictures(Vec<String>),
    /// Jobs that a batch system refused.
    Submission(String),
    /// A device that fails a test that pictures depend on.
    Unhealthy(String),
}

/// The exit code if memory or threads run out.
pub const MEMORY: u8 = 6;

/// The exit code if the device failed twice.
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
            | Self::Prepare(..)
            | Self::Untranslatable(_)
            | Self::Strict(_)
            | Self::Pictures(_) => 3,
            Self::NoDevice(_) => 4,
            Self::Files(_) => 5,
        }
    }

    /// Whether the scene or a picture is wrong, not the renderer.
    pub fn is_of_input(&self) -> bool {
        match self {
            Self::Scene(errors) => !errors.lacks_memory,
            Self::Prepare(..) | Self::Strict(_) | Self::Pictures(_) | Self::Usage(_) => true,
            _ => false,
        }
    }

    /// Its messages, as printed after `error: `.
    pub fn messages(&self) -> Vec<String> {
        match self {
            Self::Scene(errors) => {
                let each = errors.diagnostics.iter().map(ToString::to_string);
                each.chain([errors.to_string()]).collect()
            }
            Self::CommandLine(wrong) => vec![sentence(wrong)],
            Self::Prepare(scene, e) => vec![format!("{scene}: {e}")],
            Self::Render(e) => vec![e.to_string()],
            Self::Strict(warnings) => {
                let each = warnings.iter();
                each.map(|warning| format!("{warning} (--strict)"))
                    .collect()
            }
            Self::Usage(message)
            | Self::NoDevice(message)
            | Self::Memory(message)
            | Self::Submission(message)
            | Self::Unhealthy(message) => vec![message.clone()],
            Self::Lost { why, part } => {
                let resume = part.as_ref().map_or(String::new(), |part| {
                    format!(
                        "\n{part} contains the samples done by then; continue with --resume. After a CPU driver, \
                         --resume --device cpu-f32 makes the same picture, to the bit."
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

/// The error of a command line, without the advice that clap adds for people at a terminal.
fn sentence(wrong: &clap::Error) -> String {
    let text = wrong.to_string();
    let words = text.split("\n\n").next().unwrap_or(&text);
    words.trim_start_matches("error: ").trim_end().to_owned()
}
