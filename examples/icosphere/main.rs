//! Writes a displaced icosphere, a closed mesh of any size for tests and benchmarks, to a PLY file.
//!
//! `cargo run --release --example icosphere -- --triangles 100000 --displace .1 -o blob.ply`

#![allow(
    clippy::print_stderr,
    clippy::print_stdout,
    reason = "a program of its own"
)]

mod mesh;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;

use mesh::{Icosphere, frequency, ply};

/// Writes a displaced icosphere of radius 1: a closed mesh of any size
#[derive(Parser)]
struct Arguments {
    /// About how many triangles: the nearest number 20 f²
    #[arg(long, value_name = "N", default_value_t = 1000)]
    #[arg(value_parser = clap::value_parser!(u32).range(20..=50_000_000))]
    triangles: u32,
    /// Greatest displacement along the radius, from 0 to below 1
    #[arg(long, value_name = "X", default_value_t = 0.1, value_parser = displacement)]
    displace: f64,
    /// Seed of the bumps
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Write smooth normals
    #[arg(long)]
    normals: bool,
    /// The PLY file
    #[arg(short, value_name = "FILE")]
    output: PathBuf,
}

fn displacement(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(x) if (0.0..1.0).contains(&x) => Ok(x),
        _ => Err("must be a number from 0 to below 1".into()),
    }
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let frequency = frequency(arguments.triangles);
    let mesh = Icosphere::new(frequency, arguments.displace, arguments.seed);
    let normals = arguments.normals.then(|| mesh.normals());
    let (path, triangles) = (arguments.output.display(), mesh.triangles.len());
    match std::fs::write(&arguments.output, ply::bytes(&mesh, normals.as_deref())) {
        Ok(()) => {
            println!("{path}: {triangles} triangles");
            ExitCode::SUCCESS
        }
        Err(reason) => {
            eprintln!("cannot write {path}: {reason}");
            ExitCode::FAILURE
        }
    }
}
