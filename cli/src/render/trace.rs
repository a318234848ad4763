//! `vkpt SCENE --trace X,Y,I`: prints one path, vertex by vertex.

use super::arguments::RenderArguments;
use vkpt::render;
use vkpt_lab::cli::destination::all_written;
use vkpt_lab::cli::exit::{Ending, Failure};
use vkpt_lab::cli::integrator::needs_eye_paths;
use vkpt_lab::cli::job::Ready;
use vkpt_lab::cli::listing;
use vkpt_lab::cli::numbers::SamplePath;
use vkpt_lab::cli::streams::put;

/// Prints the path of one sample on stdout; writes no file.
pub fn trace(arguments: &RenderArguments, path: SamplePath) -> Result<Ending, Failure> {
    let request = arguments.request()?;
    needs_eye_paths(&request.settings, "--trace")?;
    let ready = Ready::new(&request)?;
    let job = render::Job {
        kernel: arguments.kernel,
        ..ready.job(&request)?
    };
    let [x, y] = path.pixel;
    let (width, height) = (ready.prepared.camera.width, ready.prepared.camera.height);
    if x >= width || y >= height {
        return Err(Failure::Usage(format!(
            "--trace: pixel {x},{y} is outside the picture of {width}x{height} pixels"
        )));
    }
    let trace = render::trace(&job, &arguments.target(), path.pixel, path.index)
        .map_err(Failure::Render)?;
    let mut text = format!("{trace}\n");
    let listing = ready.listing.as_deref().unwrap_or_default();
    for line in listing::named(listing, &text) {
        text += &format!("{line}\n");
    }
    all_written([put(text.as_bytes())])?;
    Ok(Ending::Complete)
}
