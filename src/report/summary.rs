//! The lines that end a rendering.

use super::error::bought;
use super::human::{count, duration, plural};
use super::{Denoised, Dropped, Job, Record};

/// The rendering, the device, the time and the files: a few short lines.
pub fn summary(record: &Record) -> String {
    let [width, height] = record.job.size;
    let crop = record.job.crop.map_or(String::new(), |[x0, y0, x1, y1]| {
        format!(", crop {x0},{y0},{x1},{y1}")
    });
    let samples = match record.job.range {
        Some([begin, end]) => format!("samples {begin}..{end} of each pixel"),
        None => format!("{} per pixel", plural(record.job.spp.into(), "sample")),
    };
    let mut lines = vec![
        format!(
            "{}: {width}×{height}{crop}, {samples}, seed {}",
            record.job.scene, record.job.seed
        ),
        format!("  on      {}", machine(record)),
    ];
    let stages = stages(record);
    if !stages.is_empty() {
        lines.push(format!("  time    {stages}"));
    }
    lines.push(format!("  work    {}", work(record)));
    if !record.files.is_empty() {
        lines.push(format!("  wrote   {}", record.files.join(", ")));
    }
    lines.push(bought(record));
    lines.extend(record.denoised.iter().flat_map(denoised));
    lines.join("\n")
}

/// The denoised picture, and a bound of the error of the same picture from half of the samples, which can be estimated.
fn denoised(of: &Denoised) -> Vec<String> {
    let bound = format!(
        "the picture denoised from half of the samples has a relMSE of at most {:.1e} (95 %); this is not the error of the noisy picture",
        of.half_rel_mse_upper
    );
    vec![
        format!(
            "  denoised {}, by {} in {}",
            of.files.join(", "),
            of.by,
            duration(of.seconds)
        ),
        bound,
    ]
}

fn machine(record: &Record) -> String {
    match record.machine.driver.as_str() {
        "" => record.machine.device.clone(),
        driver => format!("{}, {driver}", record.machine.device),
    }
}

/// The stages that took a millisecond or more.
fn stages(record: &Record) -> String {
    let s = &record.seconds;
    let all = [
        ("read", s.read),
        ("prepare", s.prepare),
        ("device", s.device),
        ("hierarchy", s.hierarchy),
        ("compose", s.compose),
        ("upload", s.upload),
        ("pipeline", s.pipeline),
        ("compile", s.compile),
        ("render", s.render),
        ("write", s.write),
    ];
    let shown = all.iter().filter(|(_, seconds)| *seconds >= 0.001);
    let shown: Vec<String> = shown
        .map(|(stage, seconds)| match (*stage, s.gpu) {
            ("render", Some(gpu)) => {
                format!("render {} (device {})", duration(*seconds), duration(gpu))
            }
            _ => format!("{stage} {}", duration(*seconds)),
        })
        .collect();
    shown.join(", ")
}

fn work(record: &Record) -> String {
    let work = &record.work;
    let rate =
        |what: Option<f64>| what.map_or(String::new(), |per_s| format!(" ({}/s)", count(per_s)));
    let underflows = match work.underflows {
        0 => String::new(),
        n => format!(", {} underflowed", plural(n, "path")),
    };
    format!(
        "{} samples{}, {} rays{}{underflows}",
        count(work.samples as f64),
        rate(work.samples_per_s),
        count(work.rays as f64),
        rate(work.rays_per_s)
    )
}

/// The samples done at a signal or a lost device; `None` if all were done.
fn early_end(job: &Job) -> Option<String> {
    let why = match &*job.ended {
        "interrupted" => "interrupted",
        "device-lost" => "the device failed",
        _ => return None,
    };
    let (spp, asked) = (job.spp, job.spp_asked);
    let what = match job.range {
        _ if spp == asked => return None,
        Some([begin, end]) => format!("the part ends before sample {end}, not {}", begin + asked),
        // With --time or --target-error no number is requested.
        None if asked == u32::MAX => format!("the picture is that of --spp {spp}"),
        None => format!("the picture is that of --spp {spp}, not {asked}"),
    };
    Some(format!("{why}: {what}"))
}

/// Warnings, a sentence each: an early end, samples that count as 0, endless paths.
pub fn concerns(record: &Record) -> Vec<String> {
    let (job, work) = (&record.job, &record.work);
    let mut sentences = Vec::new();
    sentences.extend(early_end(job));
    if let (Some(target), "complete" | "time") = (job.target_error, &*job.ended) {
        let reached = record.error.last().and_then(|e| e.high);
        let reached = reached.map_or("unknown".to_owned(), |high| format!("up to {high:.1e}"));
        sentences.push(format!(
            "the error is {reached}, not below --target-error {target:e}: --{} ended the rendering",
            if job.ended == "time" { "time" } else { "spp" }
        ));
    }
    if work.dropped.total() > 0 {
        sentences.push(format!(
            "{} of {} counted as black: {}",
            work.dropped.total(),
            plural(work.samples, "sample"),
            causes(&work.dropped)
        ));
    }
    if work.long_paths > 0 {
        sentences.push(format!(
            "{} exceeded a thousand bounces",
            plural(work.long_paths, "path")
        ));
    }
    sentences
}

/// `3 NaN, 1 infinite, 2 cut off in a loop`
fn causes(dropped: &Dropped) -> String {
    let all = [
        (dropped.nan, "NaN"),
        (dropped.infinite, "infinite"),
        (dropped.loops, "cut off in a loop"),
    ];
    let shown = all.iter().filter(|(n, _)| *n > 0);
    shown
        .map(|(n, cause)| format!("{n} {cause}"))
        .collect::<Vec<_>>()
        .join(", ")
}
