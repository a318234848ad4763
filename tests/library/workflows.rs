//! The workflows in `.github/workflows/` and docs/ci/: each is YAML, may only read, pins its actions, and names files, tests and
//! variables that exist. `vkpt` in them is run by `tests/commands/documented.rs`.

use std::fs;
use std::path::Path;

use yaml_rust2::{Yaml, YamlLoader};

const MANIFEST: &str = include_str!("../../Cargo.toml");
const NEEDS: &str = include_str!("../common/needs.rs");

/// Programs that the runners, or an earlier line, install.
const PROGRAMS: [&str; 3] = ["apt-get", "rustup", "vkpt"];

/// The oldest Rust that Cargo.toml promises.
fn oldest_rust() -> &'static str {
    let (_, rest) = MANIFEST
        .split_once("\nrust-version = \"")
        .expect("a version");
    rest.split('"').next().expect("a version")
}

/// All values under a key, at any depth.
fn values<'y>(yaml: &'y Yaml, key: &str, all: &mut Vec<&'y Yaml>) {
    match yaml {
        Yaml::Hash(entries) => {
            for (name, value) in entries {
                if name.as_str() == Some(key) {
                    all.push(value);
                }
                values(value, key, all);
            }
        }
        Yaml::Array(items) => items.iter().for_each(|item| values(item, key, all)),
        _ => {}
    }
}

/// The errors of one command.
fn fault_of_command(command: &str) -> Option<String> {
    let words: Vec<&str> = command.split_whitespace().collect();
    let after = |flag: &str| {
        let at = words.iter().position(|word| *word == flag)?;
        words.get(at + 1).copied()
    };
    let is_sound = match words[..] {
        [script, ..] if script.contains('/') => Path::new(script).is_file(),
        ["cargo", "build" | "check", ..] => true,
        ["cargo", "test", ..] => after("--test").is_none_or(|name| {
            ["tests/NAME.rs", "tests/NAME/main.rs"]
                .iter()
                .any(|path| Path::new(&path.replace("NAME", name)).is_file())
        }),
        ["rustup", "toolchain", "install", version, ..] => version == oldest_rust(),
        [program, ..] => PROGRAMS.contains(&program),
        [] => true,
    };
    (!is_sound).then(|| format!("no such command: {command}"))
}

/// `OWNER/NAME@vN`
fn is_pinned(action: &str) -> bool {
    action.split_once("@v").is_some_and(|(name, version)| {
        name.split('/').count() == 2 && version.parse::<u32>().is_ok()
    })
}

/// Everything that is wrong with a workflow.
fn faults(text: &str) -> Vec<String> {
    let yaml = match YamlLoader::load_from_str(text) {
        Ok(documents) if documents.len() == 1 => documents[0].clone(),
        Ok(_) => return vec!["not one document".to_owned()],
        Err(error) => return vec![error.to_string()],
    };
    let mut all = Vec::new();
    if yaml["on"].is_badvalue() || yaml["jobs"].as_hash().is_none() {
        all.push("neither events nor jobs".to_owned());
    }
    let under = |key| {
        let mut found = Vec::new();
        values(&yaml, key, &mut found);
        found
    };
    let texts = |key| under(key).into_iter().filter_map(Yaml::as_str);
    let unpinned = texts("uses").filter(|action| !is_pinned(action));
    all.extend(unpinned.map(|action| format!("no major version: {action}")));
    let commands = texts("run").flat_map(|run| run.split("&&").flat_map(str::lines));
    all.extend(commands.filter_map(fault_of_command));
    let rights = under("permissions");
    let rights = rights
        .iter()
        .filter_map(|rights| rights.as_hash())
        .flatten();
    let wide = rights.filter(|(_, right)| !matches!(right.as_str(), Some("read" | "none")));
    all.extend(wide.map(|(name, _)| format!("may write: {name:?}")));
    let variables = under("env");
    let variables = variables.iter().filter_map(|env| env.as_hash()).flatten();
    for (name, value) in variables {
        let name = name.as_str().unwrap_or_default();
        if name.starts_with("VKPT_TEST_") && !NEEDS.contains(&format!("\"{name}\"")) {
            all.push(format!("no such variable: {name}"));
        }
        if name == "RUSTUP_TOOLCHAIN" && value.as_str() != Some(oldest_rust()) {
            all.push(format!("not the oldest Rust: {value:?}"));
        }
    }
    all
}

#[test]
fn every_workflow_is_sound() {
    let mut count = 0;
    for folder in [".github/workflows", "docs/ci"] {
        for entry in fs::read_dir(folder).expect(folder).flatten() {
            let text = fs::read_to_string(entry.path()).expect("a text");
            assert_eq!(faults(&text), [""; 0], "{}", entry.path().display());
            count += 1;
        }
    }
    assert!(count >= 2);
}

#[test]
fn ci_reads_only_runs_everything_on_debian_and_cancels_outdated_runs() {
    let text = fs::read_to_string(".github/workflows/ci.yml").expect("a workflow");
    let yaml = &YamlLoader::load_from_str(&text).expect("YAML")[0];
    let rights = yaml["permissions"].as_hash().expect("permissions");
    assert_eq!(rights.len(), 1);
    assert_eq!(yaml["permissions"]["contents"].as_str(), Some("read"));
    assert!(!yaml["concurrency"]["cancel-in-progress"].is_badvalue());
    let steps = yaml["jobs"]["debian"]["steps"].as_vec().expect("steps");
    assert!(
        steps
            .iter()
            .any(|step| step["run"].as_str() == Some(".ci/run"))
    );
}

#[test]
fn planted_faults_are_found() {
    let sound = "on: push\njobs: { a: { steps: [{ uses: a/b@v4 }, { run: cargo test --test library }] } }\n";
    assert_eq!(faults(sound), [""; 0]);
    let oldest = oldest_rust();
    for (old, new, found) in [
        ("jobs: {", "jobs: [", "expected"),
        ("on: push", "off: push", "neither events nor jobs"),
        ("a/b@v4", "a/b@main", "no major version: a/b@main"),
        ("a/b@v4", "a/b", "no major version: a/b"),
        (
            "library",
            "libary",
            "no such command: cargo test --test libary",
        ),
        (
            "cargo test --test library",
            ".ci/walk",
            "no such command: .ci/walk",
        ),
        ("cargo test", "cargo tset", "no such command: cargo tset"),
        (
            "cargo test --test library",
            "rustup toolchain install 1.0",
            "no such command: rustup toolchain install 1.0",
        ),
        (
            "on: push",
            "on: push\npermissions: { contents: write }",
            "may write",
        ),
        (
            "on: push",
            "on: push\nenv: { VKPT_TEST_NO_GPUS: 1 }",
            "no such variable",
        ),
        (
            "on: push",
            "on: push\nenv: { RUSTUP_TOOLCHAIN: '1.0' }",
            "not the oldest Rust",
        ),
    ] {
        let wrong = sound.replace(old, new);
        let message = faults(&wrong);
        assert!(
            message.iter().any(|fault| fault.contains(found)),
            "{new}: {message:?}"
        );
    }
    assert!(
        faults(&sound.replace(
            "cargo test --test library",
            &format!("rustup toolchain install {oldest}")
        ))
        .is_empty()
    );
}
