//! Farms on a Slurm of this machine: jobs that are killed, requeued or fail, and rounds.

use std::fs;

use super::folder::Farm;
use super::slurm::{Slurm, until};
use crate::cli::program::shell;

/// One task's program is killed; another task is requeued, and one meets its time limit, which is a signal to its shell.
#[test]
fn an_array_survives_kills_and_requeues_and_merges_to_one_run() {
    let Some(slurm) = Slurm::start() else { return };
    let farm = Farm::new("64x48", &["--spp", "4096", "--tasks", "8"]);
    farm.submit(&slurm);
    let samples = ["0..512", "512..1024", "1024..1536"];
    let [killed, _requeued, timed_out] = samples.map(|samples| farm.halted(samples));
    let job = |task: &str| {
        let jobs = slurm.jobs("R");
        let found = jobs.iter().find(|job| job.ends_with(task));
        found.expect("a task that runs").clone()
    };
    killed.send("KILL");
    // Slurm wakes the processes that it ends.
    slurm.says(&["scontrol", "requeue", &job("_2")]);
    slurm.says(&["scancel", "--signal=USR1", "--batch", &job("_3")]);
    until("the script's TERM", || timed_out.has_term_pending());
    timed_out.send("CONT");
    slurm.finish();
    farm.is_one_run_of(4096);
    let parts = farm.logs("part");
    assert_eq!(parts.matches("ended with 137").count(), 1, "{parts}");
    assert_eq!(parts.matches("ended with 143").count(), 2, "{parts}");
    assert_eq!(parts.matches("try 2").count(), 1, "{parts}");
    // Two of the eight began a second time.
    assert_eq!(parts.matches("try 1").count(), 10, "{parts}");
}

/// The instructions of the merge are followed: by hand, by sbatch, and by submitting again.
#[test]
fn the_merge_says_which_parts_failed_and_how_to_render_them() {
    let Some(slurm) = Slurm::start() else { return };
    let farm = Farm::new("8x6", &["--spp", "1024", "--tasks", "4"]);
    fs::create_dir_all(farm.path("parts/unfinished")).expect("a folder");
    let states = ["0-256", "512-768"].map(|p| farm.path(&format!("parts/unfinished/{p}.vkpt")));
    for state in &states {
        fs::write(state, "not a state").expect("a file");
    }
    farm.submit(&slurm);
    slurm.finish();
    let message = farm.logs("merge");
    assert!(!farm.has_picture(), "{message}");
    for missing in [
        "part 1, samples 0 to 256, is missing",
        "part 3, samples 512 to 768, is missing",
    ] {
        assert!(message.contains(missing), "{message}");
    }
    let commands = message.lines().filter_map(|line| line.strip_prefix("    "));
    let commands: Vec<&str> = commands.collect();
    assert_eq!(commands.len(), 4, "{message}");
    assert!(
        farm.logs("part").contains("--resume cannot continue"),
        "{message}"
    );

    for state in &states {
        fs::remove_file(state).expect("a file");
    }
    let by_hand = shell(&farm.path(""), commands[1]);
    assert_eq!(by_hand.code, Some(0), "{}", by_hand.err);
    assert!(farm.path("parts/0-256.vkpt").exists(), "{message}");
    slurm.says(&["bash", "-c", commands[2]]);
    slurm.finish();
    assert!(farm.path("parts/512-768.vkpt").exists(), "{message}");
    let again = farm.submit(&slurm);
    assert!(!again.out.contains("parts:"), "{}", again.out);
    slurm.finish();
    farm.is_one_run_of(1024);
}

#[test]
fn rounds_end_at_the_target_when_time_is_up_or_with_the_last_sample() {
    let Some(slurm) = Slurm::start() else { return };
    let target = Farm::new("32x24", &["--target-error", "5e-9", "--tasks", "2"]);
    let late = Farm::new("8x6", &["--time", "1e-3", "--tasks", "1"]);
    let capped = ["--target-error", "1e-12", "--tasks", "2", "--spp", "600"];
    let capped = Farm::new("8x6", &capped);
    for farm in [&target, &late, &capped] {
        farm.submit(&slurm);
    }
    slurm.finish();
    for (farm, message) in [
        (&target, "the relMSE is below 0.000000005"),
        (&late, "more than 0.001 s"),
        (&capped, "all samples are rendered"),
    ] {
        let log = farm.logs("merge");
        assert!(log.contains(message), "{log}{}", farm.logs("part"));
    }
    late.is_one_run_of(256);
    capped.is_one_run_of(600);
    let round = fs::read_to_string(target.path("round")).expect("a number");
    let round: u32 = round.trim_end().parse().expect("a number");
    assert!(round > 1, "{}", target.logs("merge"));
    target.is_one_run_of(512 << (round - 1));
}

/// An array has fewer tasks than there are parts: the second array begins at part 1001.
#[test]
fn long_arrays_are_split() {
    let Some(slurm) = Slurm::start() else { return };
    let farm = Farm::new("1x1", &["--spp", "1003", "--tasks", "1003"]);
    // All parts but four are done: their contents do not matter here.
    fs::create_dir_all(farm.path("parts")).expect("a folder");
    for sample in (0..1003).filter(|sample| ![0, 999, 1000, 1002].contains(sample)) {
        let part = farm.path(&format!("parts/{sample}-{}.vkpt", sample + 1));
        fs::write(part, "").expect("a file");
    }
    let submitted = farm.submit(&slurm).out;
    assert_eq!(submitted.matches("parts: job").count(), 2, "{submitted}");
    slurm.finish();
    for part in ["0-1", "999-1000", "1000-1001", "1002-1003"] {
        let part = farm.path(&format!("parts/{part}.vkpt"));
        assert!(part.exists(), "{}", farm.logs("part"));
    }
}
