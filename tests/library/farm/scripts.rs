//! The texts of the scripts, read by bash and by shellcheck.

use std::fs;
use std::process::Command;

use tempfile::TempDir;
use vkpt_cli::farm::{Farm, Script, rounds, shares, slurm};

use crate::common::needs::Need;

/// Names that a shell and a template would take apart.
const SCENE: &str = "/shots/it's a \"scene\" $HOME @vkpt@ #1.txt";

fn farm() -> Farm {
    Farm {
        name: "it's".to_owned(),
        folder: "/shots/it's \"x\".farm".to_owned(),
        vkpt: "/opt/path tracer/vkpt".to_owned(),
        rendering: [SCENE, "--device", "a & b"].map(str::to_owned).into(),
        pictures: vec!["/shots/it's.exr".to_owned()],
        partition: None,
        rounds: vec![shares(0..64, 4)],
        target_error: None,
        seconds: None,
    }
}

fn in_rounds() -> Farm {
    Farm {
        partition: Some("gpu \"a\"".to_owned()),
        rounds: rounds(1 << 20, 16),
        target_error: Some(1e-3),
        seconds: Some(3600.0),
        ..farm()
    }
}

fn text(scripts: &[Script], name: &str) -> String {
    let found = scripts.iter().find(|script| script.name == name);
    found.expect("a script").text.clone()
}

/// The files in a folder.
fn written(farm: &Farm) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for script in slurm(farm) {
        fs::write(folder.path().join(script.name), script.text).expect("a script");
    }
    folder
}

#[test]
fn bash_reads_every_name_as_it_is() {
    let folder = written(&farm());
    let print = r#". ./farm.sh; command_of 16 32; printf '%s\n' "${command[@]}" "${pictures[@]}""#;
    let output = Command::new("bash")
        .args(["-c", print])
        .current_dir(folder.path())
        .output();
    let out = String::from_utf8(output.expect("bash runs").stdout).expect("UTF-8");
    let unfinished = "/shots/it's \"x\".farm/parts/unfinished/16-32.vkpt";
    let words = [
        "/opt/path tracer/vkpt",
        SCENE,
        "--device",
        "a & b",
        "--samples",
        "16..32",
        "--resume",
        "-o",
        unfinished,
        "-o",
        "/shots/it's.exr",
    ];
    assert_eq!(out.lines().collect::<Vec<_>>(), words);
}

#[test]
fn options_are_quoted_as_sbatch_reads_them() {
    let scripts = slurm(&in_rounds());
    for name in ["part.sbatch", "merge.sbatch"] {
        let text = text(&scripts, name);
        let options: Vec<&str> = text
            .lines()
            .filter(|line| line.starts_with("#SBATCH "))
            .collect();
        for option in [
            "#SBATCH --chdir=\"/shots/it's \\\"x\\\".farm\"",
            "#SBATCH --partition=\"gpu \\\"a\\\"\"",
            "#SBATCH --job-name=\"it's\"",
            "#SBATCH --requeue",
        ] {
            assert!(options.contains(&option), "{option}: {text}");
        }
        // sbatch reads none below a command.
        let head = text
            .lines()
            .take_while(|line| line.is_empty() || line.starts_with('#'));
        let in_head = head.filter(|line| line.starts_with("#SBATCH ")).count();
        assert_eq!(in_head, options.len(), "{text}");
    }
}

#[test]
fn the_scripts_have_only_the_requested_flags() {
    let [plain, rounds] = [farm(), in_rounds()].map(|farm| slurm(&farm));
    for (name, word) in [
        ("merge.sbatch", "submit.sh\n"),
        ("merge.sbatch", "high="),
        ("part.sbatch", ">started"),
        ("part.sbatch", "--partition"),
    ] {
        assert!(!text(&plain, name).contains(word), "{name}: {word}");
        assert!(text(&rounds, name).contains(word), "{name}: {word}");
    }
    assert!(text(&rounds, "merge.sbatch").contains("below \"$high\" 0.001"));
    assert!(text(&plain, "parts.txt").ends_with("1 48 64\n"));
    assert!(text(&rounds, "parts.txt").ends_with("9 1015808 1048576\n"));
    assert!(
        plain
            .iter()
            .chain(&rounds)
            .all(|script| !script.text.contains("\n\n\n"))
    );
}

#[test]
fn shellcheck_has_nothing_to_say() {
    let shellcheck = || Command::new("shellcheck").arg("--version").output();
    if Need::Shellcheck.find(shellcheck).is_none() {
        return;
    }
    for farm in [farm(), in_rounds()] {
        let folder = written(&farm);
        let scripts = ["farm.sh", "part.sbatch", "merge.sbatch", "submit.sh"];
        let checked = Command::new("shellcheck")
            .arg("--external-sources")
            .args(scripts)
            .current_dir(folder.path())
            .output();
        let checked = checked.expect("shellcheck runs");
        assert!(
            checked.status.success(),
            "{}",
            String::from_utf8_lossy(&checked.stdout)
        );
    }
}
