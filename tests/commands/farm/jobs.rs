//! Farms by a Slurm of this machine: what is killed, requeued or fails, and rounds.

use std::fs;

use super::folder::{Farm, one_run};
use super::slurm::{Slurm, until};
use crate::cli::program::shell;

/// One task's program is killed; of others, one is requeued and one meets its time limit, which is a signal to its shell.
#[test]
fn an_array_survives_kills_and_requeues_and_merges_to_one_run() {
    let Some(slurm) = Slurm::start() else { return };
    let farm = Farm::new(&["--spp", "512", "--tasks", "8"], 0.05);
    farm.submit(&slurm);
    until("four tasks that render", || slurm.jobs("R").len() == 4);
    let mut killed = Vec::new();
    until("a task to kill", || {
        killed = farm.rendering("64..128");
        !killed.is_empty()
    });
    slurm.says(&["kill", "-KILL", &killed[0]]);
    let running = slurm.jobs("R");
    slurm.says(&["scontrol", "requeue", &running[2]]);
    slurm.says(&["scancel", "--signal=USR1", "--batch", &running[3]]);
    until("two tasks that wait again", || {
        slurm
            .says(&["squeue", "-h", "-o", "%r"])
            .contains("BeginTime")
    });
    slurm.finish();
    let parts = farm.logs("part");
    assert_eq!(
        farm.picture(),
        one_run(512),
        "{parts}\n{}",
        farm.logs("merge")
    );
    assert_eq!(parts.matches("ended with 137").count(), 1, "{parts}");
    assert_eq!(parts.matches("ended with 143").count(), 2, "{parts}");
    assert_eq!(parts.matches("DUE TO JOB REQUEUE").count(), 2, "{parts}");
}

/// What the merge says to do is done: by hand, and by submitting again.
#[test]
fn the_merge_says_which_parts_failed_and_how_to_render_them() {
    let Some(slurm) = Slurm::start() else { return };
    let farm = Farm::new(&["--spp", "64", "--tasks", "4"], 0.0);
    fs::create_dir_all(farm.path("parts/unfinished")).expect("a folder");
    let states = ["0-16", "32-48"].map(|part| farm.path(&format!("parts/unfinished/{part}.vkpt")));
    states
        .iter()
        .for_each(|state| fs::write(state, "not a state").expect("a file"));
    farm.submit(&slurm);
    slurm.finish();
    let said = farm.logs("merge");
    assert!(farm.picture().is_empty(), "{said}");
    let commands: Vec<&str> = said
        .lines()
        .filter_map(|line| line.strip_prefix("    "))
        .collect();
    assert_eq!(commands.len(), 4, "{said}");
    assert!(
        said.contains("part 1, samples 0 to 16, is missing"),
        "{said}"
    );
    assert!(
        said.contains("part 3, samples 32 to 48, is missing"),
        "{said}"
    );
    assert!(farm.logs("part").contains("error: "), "{said}");

    states
        .iter()
        .for_each(|state| fs::remove_file(state).expect("a file"));
    let by_hand = shell(&farm.path(""), commands[1]);
    assert_eq!(by_hand.code, Some(0), "{}", by_hand.err);
    assert!(farm.path("parts/0-16.vkpt").exists(), "{said}");
    let by_slurm = format!("cd / && {}", commands[2]);
    slurm.says(&["bash", "-c", &by_slurm]);
    slurm.finish();
    assert!(
        farm.path("parts/32-48.vkpt").exists(),
        "{}",
        farm.logs("part")
    );
    let again = farm.submit(&slurm);
    assert!(!again.out.contains("parts:"), "{}", again.out);
    slurm.finish();
    assert_eq!(farm.picture(), one_run(64));
}

/// The error is 1 over the samples, so that 2048 are needed.
#[test]
fn rounds_end_at_the_target_or_when_time_is_up() {
    let Some(slurm) = Slurm::start() else { return };
    let target = Farm::new(&["--target-error", "6e-4", "--tasks", "2"], 0.0);
    let late = Farm::new(&["--time", "1e-3", "--tasks", "1"], 0.01);
    let capped = Farm::new(
        &["--target-error", "1e-9", "--tasks", "2", "--spp", "600"],
        0.0,
    );
    for farm in [&target, &late, &capped] {
        farm.submit(&slurm);
    }
    slurm.finish();
    for (farm, samples, said) in [
        (&target, 2048, "the relMSE is below 0.0006"),
        (&late, 256, "later than 0.001 s"),
        (&capped, 600, "all samples are rendered"),
    ] {
        let log = farm.logs("merge");
        assert!(log.contains(said), "{log}");
        assert_eq!(farm.picture(), one_run(samples), "{log}");
    }
}

/// More than one array can have: the second begins at 1001.
#[test]
fn long_arrays_are_split() {
    let Some(slurm) = Slurm::start() else { return };
    let farm = Farm::new(&["--spp", "1003", "--tasks", "1003"], 0.0);
    // All but four parts are there.
    fs::create_dir_all(farm.path("parts")).expect("a folder");
    for sample in (0..1003).filter(|sample| ![0, 999, 1000, 1002].contains(sample)) {
        let part = farm.path(&format!("parts/{sample}-{}.vkpt", sample + 1));
        fs::write(part, format!("{sample}\n")).expect("a file");
    }
    let submitted = farm.submit(&slurm);
    assert_eq!(
        submitted.out.matches("parts: job").count(),
        2,
        "{}",
        submitted.out
    );
    slurm.finish();
    assert_eq!(farm.picture(), one_run(1003), "{}", farm.logs("part"));
}
