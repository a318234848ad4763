//! Samples by Sobol are not independent: wherever their standard errors are made or believed, it is said once.

use std::path::Path;

use super::converge::LIT;
use super::program::{Run, folder, run};

const SAID: &str = "samples by --sampler sobol are not independent";

/// Warnings of it in a run that ends well.
fn warnings(run: Run) -> usize {
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert_eq!(
        run.err.lines().count(),
        run.err.matches(SAID).count(),
        "{}",
        run.err
    );
    run.err.matches(SAID).count()
}

fn words(folder: &Path, line: &str) -> usize {
    warnings(run(folder, &line.split(' ').collect::<Vec<_>>()))
}

#[test]
fn overstated_errors_are_told_where_they_are_made_and_where_they_are_believed() {
    let folder = folder(LIT);
    let of = |line: &str| words(folder.path(), line);
    let render = "scene.scn --device cpu-f32 --spp 4 --quiet --sampler";
    assert_eq!(
        of(&format!("{render} random --aov stderr -o random.exr")),
        0
    );
    assert_eq!(
        of(&format!(
            "{render} random --aov stderr -o again.exr --seed 5"
        )),
        0
    );
    assert_eq!(of(&format!("{render} sobol -o plain.exr")), 0);
    assert_eq!(of(&format!("{render} sobol --aov stderr -o sobol.exr")), 1);
    assert_eq!(of("compare random.exr again.exr --z-test"), 0);
    assert_eq!(of("compare random.exr sobol.exr --z-test"), 1);
    assert_eq!(of("compare sobol.exr sobol.exr"), 1);
    // Without standard errors there is no test.
    assert_eq!(of("compare plain.exr sobol.exr"), 0);
    let converge = "converge scene.scn --device cpu-f32 --spp 2 --time 9 --quiet --reference";
    assert_eq!(of(&format!("{converge} random.exr")), 0);
    assert_eq!(of(&format!("{converge} sobol.exr")), 1);
}
