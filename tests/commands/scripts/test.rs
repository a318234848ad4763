//! `scripts/test`: the packages that it installs, its messages, and its arguments for cargo. It runs in a custom PATH, whose
//! cargo and apt-get only record that they were called.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

use super::program::program;

/// Programs that say who was called. There is a Vulkan device once its driver is installed.
const CARGO: &str = r#"echo "cargo $*" >>"$CALLS"
[ "$1" != run ] || grep -q mesa-vulkan-drivers "$CALLS" || exit 4"#;
const APT_GET: &str = r#"echo "apt-get $*" >>"$CALLS""#;
const SUDO: &str = r#"exec "$@""#;

/// A PATH, and the file that calls are written to.
struct Machine {
    folder: TempDir,
}

/// How the script ended, its output, and the calls that it made.
struct Run {
    code: Option<i32>,
    message: String,
    calls: String,
}

impl Machine {
    /// A machine on which `programs` are installed.
    fn with(programs: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["bash", "env", "dirname", "id", "sed", "grep"] {
            let found = ["/usr/bin", "/bin"]
                .map(|folder| Path::new(folder).join(name))
                .into_iter()
                .find(|path| path.exists())
                .unwrap_or_else(|| panic!("no {name}"));
            symlink(found, folder.path().join(name)).expect("a link");
        }
        for (name, body) in programs {
            program(folder.path(), name, body);
        }
        Self { folder }
    }

    fn test(&self, arguments: &[&str], variables: &[(&str, &str)]) -> Run {
        let calls = self.folder.path().join("calls");
        fs::write(&calls, "").expect("a file");
        let output = Command::new("scripts/test")
            .current_dir(crate::common::root())
            .args(arguments)
            .env_clear()
            .env("PATH", self.folder.path())
            .env("CALLS", &calls)
            .envs(variables.iter().copied())
            .output()
            .expect("the script runs");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Run {
            code: output.status.code(),
            message: text(&output.stdout) + &text(&output.stderr),
            calls: fs::read_to_string(calls).expect("a file"),
        }
    }
}

const LINKED: [(&str, &str); 4] = [
    ("cargo", CARGO),
    ("cc", ""),
    ("apt-get", APT_GET),
    ("sudo", SUDO),
];

#[test]
fn without_the_flag_a_driver_is_installed_and_then_there_is_a_device() {
    let run = Machine::with(&LINKED).test(&["twins"], &[]);
    assert_eq!(run.code, Some(0), "{}", run.message);
    let installed = run.calls.find("apt-get -qq install").expect("an install");
    let tested = run.calls.find("cargo test twins\n").expect("tests");
    assert!(installed < tested, "{}", run.calls);
}

#[test]
fn no_install_installs_nothing_and_names_missing_packages() {
    let without = |missing: &str| {
        let there: Vec<_> = LINKED
            .into_iter()
            .filter(|(name, _)| *name != missing)
            .collect();
        Machine::with(&there).test(&["--no-install"], &[])
    };
    for (missing, message) in [
        ("cargo", "https://rustup.rs"),
        ("cc", "gcc libc6-dev"),
        ("nothing but a driver", "mesa-vulkan-drivers"),
    ] {
        let run = without(missing);
        assert_eq!(run.code, Some(1), "{missing}: {}", run.message);
        assert!(run.message.contains(message), "{missing}: {}", run.message);
        for call in ["apt-get", "cargo test"] {
            assert!(!run.calls.contains(call), "{missing}: {}", run.calls);
        }
    }
}

#[test]
fn tests_that_need_no_device_run_without_one_and_without_other_programs() {
    let run = Machine::with(&LINKED).test(
        &["twins", "--no-install", "--", "--ignored"],
        &[("VKPT_TEST_NO_GPU", "1")],
    );
    assert_eq!(run.code, Some(0), "{}", run.message);
    assert_eq!(run.calls, "cargo build\ncargo test twins -- --ignored\n");
    for package in ["spirv-tools", "chromium"] {
        assert!(run.message.contains(package), "{}", run.message);
    }
}
