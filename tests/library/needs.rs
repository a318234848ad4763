//! Requirements of tests that are missing (`tests/common/needs.rs`): tests fail, or are skipped and counted by `.ci/summary`.
#![cfg(unix)]

use std::fs;
use std::process::{Command, Output};

/// One that needs `spirv-val`.
const TEST: &str = "kernel::spirv_val_accepts_the_words_and_refuses_broken_ones";

/// That test in a process without any program.
fn without_programs(goes_without: bool) -> Output {
    let mut child = Command::new(std::env::current_exe().expect("a path"));
    child.args(["--exact", TEST]).env("PATH", "/nonexistent");
    child.env(
        "VKPT_TEST_NO_SPIRV_TOOLS",
        if goes_without { "1" } else { "" },
    );
    child.output().expect("runs")
}

/// The last lines of `.ci/run`, for a log in which cargo announces the crate.
fn summary(outputs: &[&Output]) -> String {
    let log = tempfile::NamedTempFile::new().expect("a file");
    let mut text = Vec::new();
    for output in outputs {
        text.extend_from_slice(b"     Running tests/library/main.rs (target/library)\n");
        text.extend_from_slice(&output.stderr);
        text.extend_from_slice(&output.stdout);
    }
    fs::write(log.path(), text).expect("written");
    let summary = Command::new(".ci/summary").arg(log.path()).output();
    String::from_utf8(summary.expect("awk").stdout).expect("a text")
}

#[test]
fn a_missing_program_fails_a_test_with_the_package_to_install() {
    let output = without_programs(false);
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(!output.status.success(), "{text}");
    for words in [
        "spirv-val",
        "apt-get install spirv-tools",
        "VKPT_TEST_NO_SPIRV_TOOLS=1",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert_eq!(
        summary(&[&output]),
        "tests: 0 passed, 1 failed, 0 skipped\n"
    );
}

#[test]
fn a_run_that_goes_without_says_so_and_the_test_counts_as_skipped() {
    let output = without_programs(true);
    assert!(output.status.success(), "{output:?}");
    let line = format!("skipped: {TEST}: VKPT_TEST_NO_SPIRV_TOOLS=1");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(errors.lines().any(|l| l == line), "{errors}");
    assert_eq!(
        summary(&[&output]),
        "tests: 0 passed, 0 failed, 1 skipped\n"
    );
    // In another crate a test of this name is another one.
    assert_eq!(
        summary(&[&output, &output]),
        "tests: 0 passed, 0 failed, 2 skipped\n"
    );
}
