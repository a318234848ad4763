//! The bound of a denoised picture's error on renderings, whose noise has no law that a test could assume.

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::denoise::{Denoiser, Features, Noisy};
use vkpt::film::{Aov, Film};
use vkpt::metrics::denoised::bound;
use vkpt::part::Half;
use vkpt::render::{Job, Target, layers};
use vkpt::settings::{Integrator, Sampler, Settings};

use crate::common::render::{job, outcome, prepared};
use crate::common::stats::p_of_mean;

const ALPHA: f64 = 1e-3;

/// A lamp over a floor with a sheen, rough metal, a wall, and a ball of rough glass, whose caustic paths from the eye hardly ever
/// find: most quarters miss it.
const SCENE: &str = "camera 0 -6 3 .35 x 65
light 6 5 4
sphere 0 0 4 .5
brdf .5 .4 .3 .2 .3 .2 .3
box -5 -5 -.1 10 10 .1
brdf .3 .5 .6 0 0 0 1
box -5 4 0 10 .1 5
brdf 0 0 0 .7 .6 .5 .1
box 1 -.5 .002 .8 .8 1.1
distribution ggx
brdf 0 0 0 .04 .04 .04 .2 .9 .8 .7 1.5
sphere -1.6 0 .8 .6
";

/// How renderings are tried.
struct Trials {
    integrator: Integrator,
    size: [u32; 2],
    count: u32,
    /// Samples of each of the two pictures that represent the truth.
    truth_spp: u32,
}

/// The results: for each trial the error of the estimate, and how many bounds contain the error.
struct Found {
    off: Vec<f64>,
    covered: u64,
}

impl Found {
    /// The probability that so few of ends that cover 95 times in a hundred do.
    fn p_of_coverage(&self, covered: u64) -> f64 {
        let law = Binomial::new(0.95, self.off.len() as u64).expect("a law");
        law.cdf(covered)
    }
}

/// Mean of (d − r)²/(d² + 0.01), without bias, by two pictures of r.
fn error(d: &Film, [a, b]: [&Film; 2]) -> f64 {
    let values = [d, a, b].map(|film| film.rgb.as_flattened());
    let term = |i: usize| {
        let [d, a, b] = values.map(|values| f64::from(values[i]));
        (d - a) * (d - b) / (d * d + 0.01)
    };
    let count = values[0].len();
    (0..count).map(term).sum::<f64>() / count as f64
}

/// Denoises halves of pictures of 16 samples; `judges` takes the half whose quarters judge it, of (the half itself, the other).
fn run(trials: &Trials, judges: fn([Half; 2]) -> (Half, [Film; 2])) -> Found {
    let mut settings = Settings::default();
    settings.estimator.sampler = Sampler::SobolQuarters;
    settings.estimator.integrator = trials.integrator;
    let [width, height] = trials.size;
    let scene = prepared(&format!("screen {width} {height}\n{SCENE}"), &settings);
    let of = |spp, seed| job(&scene, settings, spp, seed);
    let truth = [1, 2].map(|seed| outcome(&of(trials.truth_spp, seed), &Target::CpuF32).film);
    let mut found = Found {
        off: Vec::new(),
        covered: 0,
    };
    for seed in 100..100 + trials.count {
        let job = Job {
            aovs: &[Aov::Denoised],
            ..of(16, seed)
        };
        let outcome = outcome(&job, &Target::CpuF32);
        let halves = outcome.state.part.quartered().expect("quarters");
        let features = Job {
            aovs: &[Aov::AlbedoBehind, Aov::NormalBehind],
            seed: !seed,
            ..job
        };
        let features = Features::new(&layers(&features, 32), job.size()).expect("both layers");
        let (half, [a, b]) = judges(halves);
        let noisy = Noisy {
            mean: &half.mean,
            halves: [&half.quarters[0], &half.quarters[1]],
        };
        let denoised = Denoiser::Nlm.denoise(&noisy, &features).expect("a picture");
        let bound = bound(&denoised, [&a, &b]).expect("pictures");
        let right = error(&denoised, [&truth[0], &truth[1]]);
        found.off.push(bound.estimate - right);
        found.covered += u64::from(bound.upper >= right);
    }
    found
}

/// As it is to be: the other half judges.
fn the_other([first, second]: [Half; 2]) -> (Half, [Film; 2]) {
    (first, second.quarters)
}

/// A picture that is judged by its own samples.
fn itself([first, _]: [Half; 2]) -> (Half, [Film; 2]) {
    let quarters = first.quarters.clone();
    (first, quarters)
}

fn check_coverage(trials: &Trials) {
    let found = run(trials, the_other);
    let (p, coverage) = (
        p_of_mean(&found.off, 0.0, 0.0),
        found.p_of_coverage(found.covered),
    );
    println!(
        "{} of {} bounds hold, p = {coverage:.1e}; the estimate is unbiased, p = {p:.1e}",
        found.covered, trials.count
    );
    assert!(p > ALPHA, "p = {p:.1e}");
    assert!(coverage > ALPHA, "{} of {}", found.covered, trials.count);
    // The estimate itself is no upper end.
    let above = found.off.iter().filter(|&&off| off >= 0.0).count() as u64;
    assert!(
        found.p_of_coverage(above) < ALPHA,
        "{above} of {}",
        trials.count
    );
}

#[test]
fn bounds_cover_the_errors_of_renderings() {
    let trials = Trials {
        integrator: Integrator::Path,
        size: [40, 32],
        count: 24,
        truth_spp: 512,
    };
    check_coverage(&trials);
    let shared = run(&trials, itself);
    assert!(p_of_mean(&shared.off, 0.0, 0.0) < ALPHA);
}

#[test]
#[ignore = "two minutes: 800 renderings"]
fn bounds_cover_the_errors_of_many_renderings() {
    for integrator in [Integrator::Path, Integrator::Bidirectional] {
        check_coverage(&Trials {
            integrator,
            size: [64, 48],
            count: 400,
            truth_spp: 4096,
        });
    }
}
