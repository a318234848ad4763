//! `vkpt explain`: its output, its files and its exit codes.

use std::fs;
use std::path::Path;
use std::process::Command;

use insta::assert_snapshot;
use vkpt::settings::Settings;

use super::program::{SCENE, command, finish, folder, names, run, without_vulkan};
use crate::common;
use crate::common::needs::radv;
use crate::common::render::job;
use crate::common::root;
use crate::common::spirv_tools::tool;

#[test]
fn the_page_is_narrow_and_names_lines_buffers_and_memory() {
    let run = finish(&mut blind(root(), &["explain", "scenes/glass-table.txt"]));
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    for line in run.out.lines() {
        assert!(line.chars().count() <= 100, "{line}");
        assert_eq!(line, line.trim_end());
    }
    assert_snapshot!(without_counts(&run.out));
}

/// The program where the loader finds no driver: what it prints depends on no device.
fn blind(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = command(folder, arguments);
    command
        .env("VK_DRIVER_FILES", "/nowhere.json")
        .env("VK_ICD_FILENAMES", "/nowhere.json");
    command
}

/// The page without the size of the kernel, which every edit of a shader changes.
fn without_counts(page: &str) -> String {
    let is_counted = |line: &&str| line.trim_end().ends_with('%');
    let cut = |line: &str| {
        line.trim_end_matches(|c: char| "0123456789, %".contains(c))
            .to_owned()
    };
    let lines = page.lines().map(|line| {
        if is_counted(&line) {
            cut(line) + "  [counts]"
        } else {
            line.to_owned()
        }
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_mesh_brings_a_hierarchy_and_its_cost() {
    let run = run(root(), &["explain", "scenes/glass-mesh.txt"]);
    for words in [
        "CWBVH",
        "nodes",
        "surface area heuristic",
        "bvh_words",
        "8,126 triangles",
        "not in it, tested one by one: 4 primitives",
    ] {
        assert!(run.out.contains(words), "{words} is missing:\n{}", run.out);
    }
}

#[test]
fn no_device_is_needed_but_one_that_is_asked_for_must_be_there() {
    let folder = folder(SCENE);
    let without = |arguments: &[&str]| {
        let run = finish(&mut blind(folder.path(), arguments));
        (run.code, run.out)
    };
    let (code, out) = without(&["explain", "scene.scn"]);
    assert_eq!(code, Some(0));
    assert!(out.contains("no Vulkan device found"), "{out}");
    assert!(
        out.contains("1,048,576") || out.contains("48 pixels"),
        "{out}"
    );
    for asked in [&["--device", "0"][..], &["--statistics"]] {
        let arguments = [&["explain", "scene.scn"], asked].concat();
        assert_eq!(without(&arguments).0, Some(4), "{asked:?}");
    }
}

#[test]
fn the_spirv_is_the_module_that_renders_and_is_written_whole() {
    if without_vulkan() {
        return;
    }
    let folder = folder(SCENE);
    let arguments = ["explain", "scene.scn", "--spirv", "k.spv", "--glsl"];
    let run = run(folder.path(), &arguments);
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert_eq!(names(folder.path()), ["k.spv", "scene.scn"]);
    let written = fs::read(folder.path().join("k.spv")).expect("a module");
    let device = vkpt::gpu::Device::open(&vkpt::gpu::Selector::Best).expect("a device");
    let settings = Settings::default();
    let scene = common::render::prepared(SCENE, &settings);
    let kernels = vkpt::render::kernels(&job(&scene, settings, 1, 0), &device);
    assert!(written == kernels.expect("a kernel")[0].bytes());
    tool("spirv-val", &["--target-env", "vulkan1.1"], &written);
}

/// Bidirectional paths have a kernel for each end.
#[test]
fn each_of_two_kernels_has_a_file() {
    if without_vulkan() {
        return;
    }
    let folder = folder(SCENE);
    let arguments = [
        "explain",
        "scene.scn",
        "--spirv",
        "k.spv",
        "--integrator",
        "bidirectional",
    ];
    let run = run(folder.path(), &arguments);
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert_eq!(names(folder.path()), ["k-2.spv", "k.spv", "scene.scn"]);
    for name in ["k.spv", "k-2.spv"] {
        let module = fs::read(folder.path().join(name)).expect("a module");
        tool("spirv-val", &["--target-env", "vulkan1.1"], &module);
    }
}

/// radv compiles for an AMD GPU that does not exist, which has no memory and so renders nothing.
#[test]
fn the_drivers_statistics_are_printed_for_each_kernel() {
    let Some(radv) = radv() else { return };
    let folder = folder(SCENE);
    let message = |integrator: &str| {
        let arguments = [
            "explain",
            "scene.scn",
            "--statistics",
            "--integrator",
            integrator,
        ];
        let run = finish(
            command(folder.path(), &arguments)
                .env("RADV_FORCE_FAMILY", "navi21")
                .env("VK_DRIVER_FILES", &radv)
                .env("VK_ICD_FILENAMES", &radv)
                .env("VKPT_CACHE", ""),
        );
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{}", run.out);
        let section = run.out.split("Driver statistics of Null hardware").nth(1);
        section.expect("a section").to_owned()
    };
    let (path, both) = (message("path"), message("bidirectional"));
    assert_eq!(path.matches("Spilled VGPRs").count(), 1, "{path}");
    assert_eq!(both.matches("Spilled VGPRs").count(), 2, "{both}");
    for words in ["light paths Compute Shader", "eye paths Compute Shader"] {
        assert!(both.contains(words), "{both}");
    }
}

#[test]
fn a_driver_that_counts_nothing_says_so() {
    let Some(_) = common::cpu_driver() else {
        return;
    };
    let folder = folder(SCENE);
    let run = run(folder.path(), &["explain", "scene.scn", "--statistics"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    assert!(
        run.out.contains("\n  none: the driver lacks"),
        "{}",
        run.out
    );
}

#[test]
fn the_glsl_has_a_heading_a_file_and_nothing_else_beside_it() {
    let folder = folder(SCENE);
    let run = run(folder.path(), &["explain", "scene.scn", "--glsl"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    assert!(run.out.starts_with("#version 450\n"));
    assert!(
        run.out
            .contains("\n// ──── shaders/integrator/path/path_trace.comp ────\n")
    );
    assert!(
        run.out
            .contains("\n// ──── shaders/shape/sphere.glsl ────\n")
    );
    assert!(run.out.trim_end().ends_with('}'));
    assert!(!run.out.contains("shape/box.glsl"));
}

#[test]
fn the_full_kernel_is_larger_and_named_as_the_reason() {
    let folder = folder(SCENE);
    let full = run(folder.path(), &["explain", "scene.scn", "--kernel", "full"]);
    assert!(full.out.contains("--kernel full"), "{}", full.out);
    assert!(full.out.contains("100 %"), "{}", full.out);
    let composed = run(folder.path(), &["explain", "scene.scn"]);
    assert!(!composed.out.contains("--kernel full"), "{}", composed.out);
}

#[test]
fn each_mistake_has_its_exit_code() {
    let folder = folder("screen 8 6\n");
    let code = |arguments: &[&str]| run(folder.path(), arguments).code;
    assert_eq!(code(&["explain"]), Some(2));
    assert_eq!(code(&["explain", "scene.scn"]), Some(3));
    assert_eq!(
        code(&["explain", "scene.scn", "--spirv", "none/k.spv"]),
        Some(5)
    );
    fs::write(folder.path().join("scene.scn"), SCENE).expect("a scene file");
    assert_eq!(
        code(&["explain", "scene.scn", "--crop", "0,0,99,99"]),
        Some(2)
    );
    fs::write(folder.path().join("odd.scn"), format!("{SCENE}sphear 1\n")).expect("a scene file");
    assert_eq!(code(&["explain", "odd.scn", "--strict"]), Some(3));
    assert_eq!(names(folder.path()), ["odd.scn", "scene.scn"]);
}
