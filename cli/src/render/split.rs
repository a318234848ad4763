//! The light of the picture by classes of paths, after the picture.

use std::sync::atomic::AtomicBool;

use vkpt::film::Channel;
use vkpt::render::{End, Job, Outcome, light_classes};
use vkpt_lab::cli::exit::warn;
use vkpt_lab::cli::progress::Display;

/// The requested classes. They take as long as a rendering, so a signal ends it: the picture then lacks them, and
/// `outcome` records the interruption.
pub fn split(job: &Job, outcome: &mut Outcome, stop: &AtomicBool, quiet: bool) -> Vec<Channel> {
    let mut display = Display::new(quiet);
    let channels = light_classes(job, outcome.spp, stop, &mut |p| display.splitting(p));
    display.finish();
    channels.unwrap_or_else(|| {
        warn("interrupted: the picture is written without the layers of --aov light");
        outcome.end = End::Interrupted;
        Vec::new()
    })
}
