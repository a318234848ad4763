//! One rendering on several devices: each takes the next range of samples, as long a one as its speed allows, and the
//! parts are joined in the order of their samples.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError, mpsc};
use std::time::{Duration, Instant};

use super::course::Course;
use super::follow::Watch;
use super::joining::Joining;
use super::slices::Slices;
use super::{
    DispatchLimits, End, Job, Outcome, RenderError, Start, Stats, Target, cpu, memory, vulkan,
};
use crate::gpu::Device;
use crate::part::{BLOCK, Part};

/// The target duration of a range: long enough that devices do not wait for each other, short enough for ctrl-c.
const WANTED: Duration = Duration::from_millis(500);

/// Makes parts on a device.
pub trait Ranges {
    /// Renders these samples of every pixel.
    fn make(&mut self, samples: Range<u32>) -> Result<Part<f32>, RenderError>;
    /// Statistics so far, except those that the parts contain.
    fn took(&self) -> Stats;
}

/// Samples that no device has taken.
struct Left {
    next: u32,
    end: u32,
    /// Given back by devices that failed.
    back: Vec<Range<u32>>,
}

impl Left {
    /// The next samples, about `wanted` of them, up to the end of a block if they reach one; at most a fair share for
    /// one of `devices`.
    fn take(&mut self, wanted: u32, devices: u32) -> Option<Range<u32>> {
        if let Some(range) = self.back.pop() {
            return Some(range);
        }
        let share = (self.end - self.next).div_ceil(2 * devices);
        let end = self.next + wanted.min(share).max(1).min(self.end - self.next);
        let whole = end - end % BLOCK;
        let end = if whole > self.next { whole } else { end };
        let range = self.next..end;
        self.next = end;
        (!range.is_empty()).then_some(range)
    }
}

/// A message from a device.
enum Message {
    Made(Part<f32>),
    /// It has opened, or has ended: its statistics so far.
    Took(usize, Stats),
    Failed(usize, RenderError),
}

/// Renders as [`render_from`](super::render_from) does, on all `targets`, none of which is `cpu-f64`. A device that
/// fails leaves its samples to the others; once none is left, the result so far is returned.
///
/// # Errors
/// A device that does not exist, or cannot do what the job requires; [`RenderError::Twice`] if all have failed before
/// the first sample; [`RenderError::Start`] if it is to continue another job's samples.
pub fn render_several(
    job: &Job,
    targets: &[Target],
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, RenderError> {
    memory::check::<f32>(job, targets.len())?;
    let whole = start.part::<f32>(job)?;
    let mut joining = Joining::new(whole, targets.len());
    let mut course = Course::new(job, stop, start, WANTED);
    let left = Mutex::new(Left {
        next: start.range().end,
        end: job.spp.max(start.range().end),
        back: Vec::new(),
    });
    let mut alive: Vec<usize> = (0..targets.len()).collect();
    let (mut failure, mut wrong) = (None, false);
    // Samples that the last device has left are available once the others have ended.
    while !course.has_ended() && !alive.is_empty() {
        let halt = AtomicBool::new(false);
        let (sender, messages) = mpsc::channel();
        std::thread::scope(|scope| {
            for &i in &alive {
                let (sender, left, halt, target) = (sender.clone(), &left, &halt, &targets[i]);
                let count = alive.len() as u32;
                scope.spawn(move || work(job, target, i, count, left, &[stop, halt], &sender));
            }
            drop(sender);
            for message in messages {
                match message {
                    Message::Made(part) => joining.take(part, &mut course, watch),
                    Message::Took(i, stats) => joining.stats[i] = Some(stats),
                    Message::Failed(i, error) => {
                        alive.retain(|&other| other != i);
                        wrong |= !error.is_loss();
                        if error.is_loss() && !alive.is_empty() {
                            watch.lost(&error, "the others continue without it");
                        }
                        failure = Some(error);
                    }
                }
                halt.store(wrong || course.has_ended(), Ordering::Relaxed);
            }
        });
        if wrong || stop.load(Ordering::Relaxed) {
            break;
        }
    }
    course.look_at_the_end(|| joining.whole.halves());
    let so_far = course.so_far(joining.part(), joining.stats());
    match failure {
        Some(error) if wrong => Err(error),
        Some(error) if alive.is_empty() && so_far.spp == 0 => {
            Err(RenderError::Twice(Box::new(error)))
        }
        Some(error) if alive.is_empty() => Ok(Outcome {
            end: End::Lost,
            failure: Some(error.to_string()),
            ..so_far
        }),
        _ => Ok(so_far),
    }
}

/// Makes parts until no samples are left, or it is stopped.
fn work(
    job: &Job,
    target: &Target,
    i: usize,
    devices: u32,
    left: &Mutex<Left>,
    stops: &[&AtomicBool],
    sender: &mpsc::Sender<Message>,
) {
    let mut slices = Slices::new(WANTED);
    let lock = || left.lock().unwrap_or_else(PoisonError::into_inner);
    let stopped = || stops.iter().any(|stop| stop.load(Ordering::Relaxed));
    let ended = with_ranges(job, target, &mut |ranges| {
        let _ = sender.send(Message::Took(i, ranges.took()));
        while !stopped() {
            let Some(range) = lock().take(slices.next(u32::MAX), devices) else {
                break;
            };
            let began = Instant::now();
            match ranges.make(range.clone()) {
                Ok(part) => {
                    slices.took(range.len() as u32, began.elapsed());
                    // The receiver is gone only if a panic has ended the rendering.
                    let _ = sender.send(Message::Made(part));
                }
                Err(error) => {
                    lock().back.push(range);
                    return Err(error);
                }
            }
        }
        Ok(ranges.took())
    });
    let _ = sender.send(match ended {
        Ok(stats) => Message::Took(i, stats),
        Err(error) => Message::Failed(i, error),
    });
}

/// Opens the device, and runs `work` with its maker of parts.
fn with_ranges(
    job: &Job,
    target: &Target,
    work: &mut dyn FnMut(&mut dyn Ranges) -> Result<Stats, RenderError>,
) -> Result<Stats, RenderError> {
    match target {
        Target::Vulkan(selector) => {
            let device = Device::open(selector)?;
            let limits = DispatchLimits::of(&device)?;
            vulkan::with_ranges(job, &device, limits, work)
        }
        Target::CpuF32 => cpu::with_ranges(job, work),
        Target::CpuF64 => Err(RenderError::Start),
    }
}
