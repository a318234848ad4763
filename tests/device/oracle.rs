//! The scene of `tests/data/oracle`, which Mitsuba 3.9 has rendered to convergence, with its standard errors (model.md,
//! "Another renderer").

use std::path::PathBuf;

use statrs::distribution::{ContinuousCDF, Normal};
use vkpt::film::{Aov, Film};
use vkpt::image::{Picture, Precision};
use vkpt::metrics::StandardErrors;
use vkpt::metrics::blocks::{ALPHA, Block, BlockTest, Estimate, Stderr, z_test};
use vkpt::prepared::Prepared;
use vkpt::render::{Job, Outcome, Target};
use vkpt::settings::{Integrator, Settings};

use crate::common;
use crate::common::data::data;
use crate::common::render::{job, on_device, outcome, prepared_file};
use crate::common::settings::by;

/// Means of blocks then have errors near .4 %: 1 % is seen, if not in every block.
const SPP: u32 = 256;

fn file(name: &str) -> PathBuf {
    data("oracle").join(name)
}

struct Oracle {
    scene: Prepared,
    mean: Picture,
    stderr: Picture,
}

fn oracle() -> Oracle {
    let settings = Settings::default();
    let picture = |name| {
        let path = file(name);
        vkpt::image::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
    };
    Oracle {
        scene: prepared_file(&file("cornell-beer.scn"), &settings, None),
        mean: picture("cornell-beer.exr"),
        stderr: picture("cornell-beer-stderr.exr"),
    }
}

impl Oracle {
    fn job(&self, seed: u32) -> Job<'_> {
        Job {
            aovs: &[Aov::Stderr],
            ..job(&self.scene, Settings::default(), SPP, seed)
        }
    }

    fn test(&self, film: &Film, stderr: &Film) -> BlockTest {
        let oracle = Estimate {
            mean: &self.mean.film,
            stderr: Stderr::PerPixel(StandardErrors::exact(&self.stderr.film)),
            precision: self.mean.precision,
        };
        let ours = Estimate {
            mean: film,
            stderr: Stderr::PerPixel(StandardErrors {
                film: stderr,
                // Two groups of Sobol's points.
                freedom: 1.0,
            }),
            precision: Precision::Single,
        };
        z_test(&ours, &oracle, ALPHA).expect("two pictures of one size")
    }

    /// Our picture agrees, and 1 % more of it, or a row moved by one pixel, does not.
    fn judge(&self, outcome: &Outcome) {
        let stderr = outcome.stderr.as_ref().expect("standard errors");
        let test = self.test(&outcome.film, stderr);
        let [mean, deviation] = test.spread().expect("noise");
        let worst = test.worst();
        println!(
            "z: mean {mean:.2}, standard deviation {deviation:.2}, worst {:.2} at {:?}",
            worst.z, worst.origin
        );
        assert!(test.passes(), "{worst:?}");
        for (name, factor) in [("×1.01", 1.01), ("×0.99", 0.99)] {
            let planted = mapped(&outcome.film, |x| x * factor);
            let test = self.test(&planted, stderr);
            println!(
                "{name}: {} of {} rejected",
                test.rejected(),
                test.blocks().len()
            );
            assert!(!test.passes(), "{name} passes");
        }
        assert!(!self.test(&shifted(&outcome.film), stderr).passes());
        self.each_block_notices(&outcome.film, stderr);
    }

    /// 5 % more: each block must notice where that is five standard errors above the test's critical value. So it is where
    /// both pictures together know the block's mean to half a per cent.
    fn each_block_notices(&self, film: &Film, stderr: &Film) {
        let test = self.test(&mapped(film, |x| x * 1.05), stderr);
        let critical = Normal::standard().inverse_cdf(1.0 - test.level() / 2.0);
        let must = |b: &&Block| 0.05 * b.means[1] > (critical + 5.0) * b.stderr;
        let blocks = test.blocks().iter().filter(must);
        println!("5 % must be noticed in {} blocks", blocks.clone().count());
        for block in blocks {
            assert!(block.p < test.level(), "{block:?}");
        }
    }
}

fn mapped(film: &Film, f: impl Fn(f32) -> f32) -> Film {
    Film {
        rgb: film.rgb.iter().map(|p| p.map(&f)).collect(),
        ..*film
    }
}

/// Every row one pixel to the right, the last pixel to its front.
fn shifted(film: &Film) -> Film {
    let mut film = film.clone();
    for row in film.rgb.chunks_mut(film.width as usize) {
        row.rotate_right(1);
    }
    film
}

#[test]
fn the_device_agrees_with_mitsuba() {
    let oracle = oracle();
    if let Some(outcome) = on_device(&oracle.job(1)) {
        oracle.judge(&outcome);
    }
}

#[test]
fn the_reference_agrees_with_mitsuba() {
    let oracle = oracle();
    oracle.judge(&outcome(&oracle.job(2), &Target::CpuF64));
}

/// Light through the ball of glass found by connections and splats.
#[test]
fn bidirectional_paths_agree_with_mitsuba() {
    let oracle = oracle();
    let job = Job {
        settings: by(Integrator::Bidirectional),
        ..oracle.job(4)
    };
    oracle.judge(&outcome(&job, &Target::CpuF32));
}

/// A swapped lobe: the glass ball reflects what it should transmit.
#[test]
fn a_mirror_in_place_of_the_glass_is_noticed() {
    let mut oracle = oracle();
    let text = std::fs::read_to_string(file("cornell-beer.scn")).expect("the scene");
    let swapped = text.replace(
        "brdf 0 0 0  .04 .04 .04  0.05  0.9 0.4 0.12  1.5",
        "brdf 0 0 0  .9 .4 .12  0.05",
    );
    assert_ne!(text, swapped);
    oracle.scene = common::render::prepared(&swapped, &Settings::default());
    let job = Job {
        spp: 16,
        ..oracle.job(3)
    };
    let outcome = outcome(&job, &Target::CpuF32);
    let stderr = outcome.stderr.as_ref().expect("standard errors");
    assert!(!oracle.test(&outcome.film, stderr).passes());
}
