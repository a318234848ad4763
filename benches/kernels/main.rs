//! Every scene with the full kernel and with the composed one, in alternation.
//!
//! ```sh
//! cargo bench --bench kernels -- --out docs/records/2026-01-31-kernels
//! ```
//!
//! writes `raw.jsonl`, a line a run (vkpt's own report, with the seconds of the whole process), and `tables.md`. The
//! compared runs alternate: composed, full, composed, full. Scenes are those of `scenes/`, and those of a folder
//! `../shared/scenes` if it exists. Compiling is measured separately from rendering: `cold` without vkpt's and Mesa's
//! caches (other drivers' caches are not known here), `warm` with both, after a run that fills them.

#![allow(clippy::print_stderr, reason = "a program of its own")]

mod run;
mod tables;

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Parser;
use run::{Kind, Run, run};
use vkpt::gpu::{Device, Selector};

#[derive(Parser)]
struct Arguments {
    /// Folder for the results
    #[arg(long)]
    out: PathBuf,
    /// Runs of each kernel, each scene and each kind
    #[arg(long, default_value_t = 5)]
    rounds: usize,
    /// Samples per pixel where time per sample is measured
    #[arg(long, default_value_t = 64)]
    spp: u32,
    #[arg(long, default_value = "160x120")]
    size: String,
    /// Another device than the best
    #[arg(long)]
    device: Option<String>,
    /// Scene files [default: all]
    scenes: Vec<PathBuf>,
    /// What `cargo bench` adds.
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = Arguments::parse();
    // Cargo runs benchmarks in their package's folder, `cli/`.
    std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))?;
    // The program itself may choose cpu-f32, which has no kernel.
    if arguments.device.is_none() {
        let best = Device::open(&Selector::Best)?;
        arguments.device = Some(best.info().index.to_string());
    }
    std::fs::create_dir_all(&arguments.out)?;
    let scenes = scenes(&arguments)?;
    let mut runs = Vec::new();
    for scene in scenes {
        eprintln!("{}", scene.display());
        measure(&arguments, &scene, &mut runs)?;
    }
    let raw: String = runs.iter().map(|r: &Run| format!("{}\n", r.json)).collect();
    std::fs::write(arguments.out.join("raw.jsonl"), raw)?;
    std::fs::write(arguments.out.join("tables.md"), tables::tables(&runs))?;
    Ok(())
}

fn scenes(arguments: &Arguments) -> std::io::Result<Vec<PathBuf>> {
    if !arguments.scenes.is_empty() {
        return Ok(arguments.scenes.clone());
    }
    let mut all = Vec::new();
    for folder in ["scenes", "../shared/scenes"].map(Path::new) {
        if !folder.is_dir() {
            continue;
        }
        for entry in folder.read_dir()? {
            let path = entry?.path();
            if path.extension().is_some_and(|e| e == "txt" || e == "scn") {
                all.push(path);
            }
        }
    }
    all.sort();
    Ok(all)
}

/// All kinds of runs of one scene.
fn measure(arguments: &Arguments, scene: &Path, runs: &mut Vec<Run>) -> Result<(), Box<dyn Error>> {
    for kind in [Kind::Cold, Kind::Fill, Kind::Warm, Kind::Render] {
        let rounds = if kind == Kind::Fill {
            1
        } else {
            arguments.rounds
        };
        for _ in 0..rounds {
            for full in [false, true] {
                let done = run(arguments, scene, kind, full)?;
                runs.extend((kind != Kind::Fill).then_some(done));
            }
        }
    }
    Ok(())
}
