//! Compiled kernels on disk, and the statistics that drivers report about them.
//!
//! lavapipe's pipeline cache is empty. Mesa's radv, which the same package installs, compiles for AMD's GPUs where
//! there is none: `RADV_FORCE_FAMILY` gives it null hardware, on which kernels compile and nothing runs. Processes
//! with that variable represent processes on a GPU.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use vkpt::gpu::{BufferUse, Device, Options, Selector, Statistic};
use vkpt::kernel::{Composer, Spirv, compile};

use crate::common;
use crate::common::needs::{Need, radv};

/// x[i] ← x[i]·k + i, `steps` times, written out.
fn kernel(steps: usize) -> Spirv {
    let body = "    x = x * 1.0001 + float(i) / (x + 2.0);\n".repeat(steps);
    let text = format!(
        "layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) buffer Numbers {{ float x[]; }} numbers;
void main() {{
    uint i = gl_GlobalInvocationID.x;
    float x = numbers.x[i];
{body}    numbers.x[i] = x;
}}
"
    );
    let composed = Composer::new().add("root", text).compose(&["root"]);
    composed.and_then(|k| compile(&k)).expect("a valid kernel")
}

// ---- the process on a GPU

/// Compiles `kernel(STEPS)` with the cache CACHE, and prints the driver's counts if STATISTICS is set.
#[test]
#[ignore = "run by the tests below, in processes of their own"]
fn child_that_compiles() {
    let variable = |name| std::env::var(name).ok();
    let options = Options {
        cache: variable("CACHE").map(PathBuf::from),
        statistics: variable("STATISTICS").is_some(),
        ..Options::default()
    };
    let steps = variable("STEPS").and_then(|n| n.parse().ok());
    let device = Device::open_with(&Selector::Best, options).expect("a device");
    let made = device.pipeline(&kernel(steps.unwrap_or(1)), &[BufferUse::Storage], 0);
    let statistics = made.and_then(|p| p.statistics()).expect("compiled");
    for Statistic { name, value, .. } in &statistics {
        println!("\nstatistic {name}={value}");
    }
}

#[test]
#[ignore = "run by the test below, in processes of its own"]
fn child_that_prints_its_folder() {
    println!("\nfolder {:?}", Options::from_env().cache);
}

fn child(test: &str, variables: &[(&str, &str)]) -> Child {
    Command::new(std::env::current_exe().expect("a path"))
        .args(["--exact", test, "--ignored", "--nocapture"])
        .envs(variables.iter().copied())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("runs")
}

/// The child's lines, once it has ended well.
fn lines(child: Child) -> Vec<String> {
    let output = child.wait_with_output().expect("ends");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}{errors}");
    text.lines().map(str::to_owned).collect()
}

/// Starts to compile for a GPU that does not exist. Mesa's own cache is off: every hit is in vkpt's.
fn start(radv: &str, cache: &Path, variables: &[(&str, &str)]) -> Child {
    let cache = cache.display().to_string();
    let mut all = vec![
        ("CACHE", cache.as_str()),
        ("RADV_FORCE_FAMILY", "navi21"),
        ("VK_DRIVER_FILES", radv),
        ("VK_ICD_FILENAMES", radv),
        ("MESA_SHADER_CACHE_DISABLE", "true"),
    ];
    all.extend(variables);
    child("gpu_cache::child_that_compiles", &all)
}

/// All files of a folder, with the values that distinguish a file from its replacement.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries
        .map(|entry| (entry.path(), fs::read(entry.path()).expect("a file")))
        .collect()
}

/// A file is replaced, never written to: it is the same as long as it has the same inode.
#[cfg(unix)]
fn inode(path: &Path) -> u64 {
    std::os::unix::fs::MetadataExt::ino(&fs::metadata(path).expect("a file"))
}

// ---- the cache

#[test]
fn nothing_is_written_where_the_driver_keeps_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let options = Options {
        cache: Some(folder.path().join("cache")),
        ..Options::default()
    };
    let lavapipe = || Device::open_with(&Selector::from("llvmpipe"), options);
    let Some(device) = Need::Lavapipe.find(lavapipe) else {
        return;
    };
    let buffer = device.buffer("numbers", BufferUse::Storage, 256);
    let (buffer, pipeline) = (
        buffer.expect("a buffer"),
        device.pipeline(&kernel(1), &[BufferUse::Storage], 0),
    );
    let pipeline = pipeline.expect("a pipeline");
    let run = device.dispatch(&pipeline, &[&buffer], &[], [1, 1, 1]);
    run.expect("runs");
    drop((buffer, pipeline, device));
    assert!(!folder.path().join("cache").exists());
}

#[cfg(unix)]
#[test]
fn a_kernel_is_kept_and_found_by_the_next_process() {
    let Some(radv) = radv() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    lines(start(&radv, folder.path(), &[]));
    let kept = files(folder.path());
    assert_eq!(kept.len(), 1);
    let (path, content) = kept.first_key_value().expect("a file");
    assert!(content.len() > 16 + 32, "magic, checksum, Vulkan's header");
    let first = inode(path);
    lines(start(&radv, folder.path(), &[]));
    assert_eq!(inode(path), first, "found: nothing is left to add");
    lines(start(&radv, folder.path(), &[("STEPS", "2")]));
    assert_eq!(files(folder.path()).len(), 2, "another kernel");
    let other_gpu = [("RADV_FORCE_FAMILY", "vega10")];
    lines(start(&radv, folder.path(), &other_gpu));
    assert_eq!(files(folder.path()).len(), 3, "another device");
    assert_eq!(inode(path), first);
}

#[cfg(unix)]
#[test]
fn a_file_that_is_not_right_is_ignored_and_replaced() {
    let Some(radv) = radv() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    lines(start(&radv, folder.path(), &[]));
    let right = files(folder.path());
    let (path, content) = right.first_key_value().expect("a file");
    let elsewhere = tempfile::tempdir().expect("a folder");
    lines(start(&radv, elsewhere.path(), &[("STEPS", "2")]));
    let other_kernel = files(elsewhere.path()).into_values().next();
    let mut corrupt = content.clone();
    corrupt[content.len() / 2] ^= 1;
    for (what, wrong) in [
        ("corrupt", corrupt),
        ("truncated", content[..content.len() / 2].to_vec()),
        ("longer", [&content[..], b"x"].concat()),
        ("empty", Vec::new()),
        ("the driver's data alone", content[16..].to_vec()),
        ("of another kernel", other_kernel.expect("a file")),
    ] {
        fs::write(path, wrong).expect("written");
        lines(start(&radv, folder.path(), &[]));
        assert_eq!(files(folder.path()), right, "{what}");
    }
}

#[cfg(unix)]
#[test]
fn processes_at_once_leave_one_whole_file() {
    let Some(radv) = radv() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let children: Vec<_> = (0..4).map(|_| start(&radv, folder.path(), &[])).collect();
    children.into_iter().for_each(|child| drop(lines(child)));
    let kept = files(folder.path());
    assert_eq!(kept.len(), 1);
    let path = kept.first_key_value().expect("a file").0;
    let before = inode(path);
    lines(start(&radv, folder.path(), &[]));
    assert_eq!(inode(path), before, "it is right");
}

#[test]
fn a_folder_that_cannot_be_written_is_no_error() {
    let Some(radv) = radv() else { return };
    let file = tempfile::NamedTempFile::new().expect("a file");
    lines(start(&radv, &file.path().join("below a file"), &[]));
    lines(start(&radv, Path::new("/proc"), &[]));
}

#[cfg(target_os = "linux")]
#[test]
fn the_folder_is_the_users_unless_the_environment_names_another() {
    for (variables, expected) in [
        (
            &[("HOME", "/h"), ("XDG_CACHE_HOME", "")][..],
            Some("/h/.cache/vkpt"),
        ),
        (
            &[("HOME", "/h"), ("XDG_CACHE_HOME", "relative")],
            Some("/h/.cache/vkpt"),
        ),
        (&[("HOME", "/h"), ("XDG_CACHE_HOME", "/x")], Some("/x/vkpt")),
        (
            &[("XDG_CACHE_HOME", "/x"), ("VKPT_CACHE", "/v")],
            Some("/v"),
        ),
        (&[("XDG_CACHE_HOME", "/x"), ("VKPT_CACHE", "")], None),
    ] {
        let expected = format!("folder {:?}", expected.map(PathBuf::from));
        let printed = lines(child("gpu_cache::child_that_prints_its_folder", variables));
        assert!(printed.contains(&expected), "{variables:?}: {printed:?}");
    }
}

// ---- statistics

/// By name, as the child prints them.
fn statistics(radv: &str, steps: &str) -> BTreeMap<String, f64> {
    let folder = tempfile::tempdir().expect("a folder");
    let asked = [("STEPS", steps), ("STATISTICS", "1")];
    let twice = [(); 2].map(|_| {
        let printed = lines(start(radv, folder.path(), &asked));
        let numbers = printed.iter().filter_map(|line| {
            let (name, value) = line.strip_prefix("statistic ")?.split_once('=')?;
            Some((name.to_owned(), value.parse().ok()?))
        });
        numbers.collect::<BTreeMap<_, _>>()
    });
    assert_eq!(
        twice[0], twice[1],
        "a kernel out of the cache counts the same"
    );
    twice[0].clone()
}

#[test]
fn a_gpu_reports_instructions_and_registers() {
    let Some(radv) = radv() else { return };
    let (small, large) = (statistics(&radv, "1"), statistics(&radv, "40"));
    for name in ["Instructions", "Code size"] {
        assert!(
            small[name] > 0.0 && large[name] > 10.0 * small[name],
            "{name}"
        );
    }
    assert!(
        small.contains_key("VGPRs") && small.contains_key("SGPRs"),
        "{small:?}"
    );
    let names: Vec<_> = small.keys().collect();
    assert_eq!(names, large.keys().collect::<Vec<_>>());
}

#[test]
fn there_are_no_statistics_without_asking() {
    let Some(radv) = radv() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let printed = lines(start(&radv, folder.path(), &[]));
    assert!(!printed.iter().any(|line| line.starts_with("statistic ")));
}

/// The query is valid on any device of the tests; lavapipe lacks the extension and reports nothing.
#[test]
fn asking_for_statistics_is_no_error_anywhere() {
    let Some(device) = common::open(Options {
        statistics: true,
        ..Options::default()
    }) else {
        return;
    };
    let pipeline = device.pipeline(&kernel(1), &[BufferUse::Storage], 0);
    let statistics = pipeline.and_then(|p| p.statistics()).expect("no error");
    if device.info().name.contains("llvmpipe") {
        assert_eq!(statistics, []);
    }
    assert_eq!(device.validation_messages(), [""; 0]);
}
