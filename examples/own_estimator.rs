//! Tries another estimator without a change to vkpt: the balance heuristic in place of the power heuristic.
//!
//! ```sh
//! cargo run --release --example own_estimator -- scenes/room.txt
//! ```
//!
//! A kernel is composed of the files of `shaders/`; [`KernelChoice::Own`] replaces some of them. An estimator must not
//! move the mean of the picture, so both means are printed with their standard errors over 8 seeds, next to the mean
//! error of a picture. `vkpt-lab`'s `converge` does the same over time, pixel by pixel.

#![allow(clippy::print_stdout, reason = "a program of its own")]

use std::error::Error;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use vkpt::kernel::OwnFile;
use vkpt::metrics::mean;
use vkpt::prepared::{Prepared, prepare};
use vkpt::render::{Job, KernelChoice, RenderError, Selector, Target, Until, render};
use vkpt::scene;
use vkpt::settings::Settings;

/// w = p/(p + q) (Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997, equation 9.8), written
/// 1/(1 + q/p) against overflow. Names and arguments are those of the file that it replaces.
const BALANCE: OwnFile = OwnFile {
    name: "integrator/path/connect/mis",
    text: "
float balance_heuristic(float p, float q) {
    return 1.0 / (1.0 + q / p);
}

float connection_weight(float light_pdf, float bsdf_pdf) {
    return balance_heuristic(light_pdf, bsdf_pdf);
}

float hit_weight(bool delta, float bsdf_pdf, float light_pdf) {
    return delta ? 1.0 : balance_heuristic(bsdf_pdf, light_pdf);
}
",
};

/// Pictures of each estimator.
const SEEDS: u32 = 8;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os()
        .nth(1)
        .ok_or("usage: own_estimator SCENE")?;
    let read = scene::read(Path::new(&path), false)?;
    let size = Some([100, 75]);
    let prepared = prepare(&read.scene, &Settings::default(), size)?;
    for (name, kernel) in [
        ("power heuristic", KernelChoice::Composed),
        ("balance heuristic", KernelChoice::Own(&[BALANCE])),
    ] {
        let (means, errors) = pictures(&prepared, kernel)?;
        let [mean, spread] = statistics(&means);
        let [error, _] = statistics(&errors);
        println!("{name:18}  mean {mean:.5} ± {spread:.5}  relMSE {error:.2e}");
    }
    Ok(())
}

/// The mean of each picture over pixels and channels, and its estimated relMSE.
fn pictures(
    prepared: &Prepared,
    kernel: KernelChoice,
) -> Result<(Vec<f64>, Vec<f64>), RenderError> {
    let (mut means, mut errors) = (Vec::new(), Vec::new());
    for seed in 0..SEEDS {
        let job = Job {
            prepared,
            settings: Settings::default(),
            spp: 64,
            until: Until::default(),
            seed,
            crop: None,
            aovs: &[],
            classes: &[],
            kernel,
        };
        // The reference has no kernel: custom files need a Vulkan device. Mesa's lavapipe is one.
        let device = Target::Vulkan(Selector::Best);
        let outcome = render(&job, &device, &AtomicBool::new(false), &mut |_| {})?;
        means.push(mean(&outcome.film).iter().sum::<f64>() / 3.0);
        let last = outcome.state.errors.last();
        errors.extend(last.and_then(|error| error.rel_mse).map(|e| e.estimate));
    }
    Ok((means, errors))
}

/// The mean of independent values, and its standard error.
fn statistics(values: &[f64]) -> [f64; 2] {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|x| (x - mean).powi(2)).sum();
    [mean, (squares / (n * (n - 1.0))).sqrt()]
}
