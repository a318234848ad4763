//! How far an experiment is, in words.

use vkpt::report::human::duration;

use crate::cli::progress::Display;
use crate::converge::{Part, Progress};

/// Shows how far the experiment is.
pub fn show(display: &mut Display, progress: &Progress) {
    let fraction = (progress.spent_s / progress.seconds).min(1.0);
    display.show(fraction, || words(progress));
}

/// `step 3: 4 spp, replicate 5 of 8, variant 1 of 6, 12.0 s of 1 min 00 s`
fn words(progress: &Progress) -> String {
    let samples = format!("{} spp", progress.spp);
    let what = match progress.part {
        Part::Reference => format!("reference: {samples}"),
        Part::Step {
            number,
            replicate: [replicate, replicates],
            variant: [variant, variants],
        } => {
            let variant = match variants {
                1 => String::new(),
                _ => format!(", variant {variant} of {variants}"),
            };
            format!("step {number}: {samples}, replicate {replicate} of {replicates}{variant}")
        }
    };
    let [spent, seconds] = [progress.spent_s, progress.seconds].map(duration);
    format!("{what}, {spent} of {seconds}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_experiment_reports_its_replicate_and_the_time_spent() {
        let at = |part| {
            words(&Progress {
                part,
                spp: 4,
                spent_s: 12.0,
                seconds: 60.0,
            })
        };
        let step = |variants| {
            at(Part::Step {
                number: 3,
                replicate: [5, 8],
                variant: [1, variants],
            })
        };
        let time = "12.0 s of 1 min 00 s";
        assert_eq!(at(Part::Reference), format!("reference: 4 spp, {time}"));
        assert_eq!(step(1), format!("step 3: 4 spp, replicate 5 of 8, {time}"));
        let six = format!("step 3: 4 spp, replicate 5 of 8, variant 1 of 6, {time}");
        assert_eq!(step(6), six);
    }
}
