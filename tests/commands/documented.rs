//! Every command line in README.md, the pages of docs/ and the help of the commands is run, and succeeds.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

use crate::cli::program::{finish, names, run, without_vulkan, words};
use crate::common::models::{Model, lamp};
use crate::common::root;
use crate::scripts::program::program;

const README: &str = include_str!("../../README.md");

/// Pages whose command lines others run: those of cli.md are the help's, those of farm.md below its first heading are run by
/// `farm::page`, those of python.md by pytest.
const ELSEWHERE: [&str; 3] = ["cli.md", "farm.md", "python.md"];

/// The commands that have a page of help.
const COMMANDS: [&str; 14] = [
    "render",
    "init",
    "devices",
    "merge",
    "converge",
    "compare",
    "test",
    "check",
    "doctor",
    "explain",
    "export",
    "farm slurm",
    "farm",
    "",
];

/// As small as possible: the lines are the same for any scene.
const SCENE: &str = "screen 8 6\ncamera 0 0 5 .3\nlight 1 1 1\nbox 0 0 1 .3 .3 .3\nbrdf .5 .5 .5 0 0 0 1\nbox -1 -1 -1 2 2 1.5\n";

/// Replacements for lines that take long; the words are the same to the program.
const CHEAPER: [(&str, &str); 11] = [
    ("--size 640x480", "--size 8x6"),
    ("--time 60", "--time 0.2"),
    ("--time 3600", "--time 0.2"),
    ("vkpt converge ", "vkpt converge --device cpu-f32 "),
    // So few pixels as these may never have an interval.
    ("--target-error 1e-3", "--target-error 1e-3 --spp 64"),
    ("--spp 65536", "--spp 64"),
    ("check --quick", "check --quick --case alpha/ggx/1e-3"),
    ("100,100,164,164", "1,1,5,4"),
    ("178,8,256,104", "1,1,5,4"),
    // There is one device here.
    ("--device 1", "--device 0"),
    ("--submit", ""),
];

/// README.md and the pages of `docs/`; farm.md only above its headings.
fn pages() -> Vec<String> {
    let read = |path: &Path| fs::read_to_string(path).expect("a page");
    let docs = root().join("docs");
    let names = names(&docs).into_iter();
    let names = names.filter(|name| name.ends_with(".md") && !ELSEWHERE.contains(&&**name));
    let mut pages: Vec<String> = names.map(|name| read(&docs.join(name))).collect();
    pages.push(README.to_owned());
    let farm = read(&docs.join("farm.md"));
    pages.extend(farm.split("\n## ").next().map(str::to_owned));
    pages
}

/// The lines of blocks that run vkpt, and of `run:` in workflows, without comments.
fn of_page(page: &str) -> Vec<String> {
    let blocks = page.split("```").skip(1).step_by(2);
    let lines = blocks.flat_map(str::lines).map(str::trim);
    let lines = lines.map(|line| line.strip_prefix("- run: ").unwrap_or(line));
    let shown = lines.filter(|line| line.starts_with("vkpt ") || line.contains("| vkpt "));
    shown.map(|line| uncommented(line).to_owned()).collect()
}

/// The command lines within the text of a page; a command alone, such as `vkpt merge`, is none.
fn of_text(page: &str) -> Vec<String> {
    let text = page.split("```").step_by(2);
    let code = text.flat_map(|text| text.split('`').skip(1).step_by(2));
    let lines = code.filter(|code| code.starts_with("vkpt ") && code.split(' ').count() > 2);
    lines.map(str::to_owned).collect()
}

/// The line without its comment.
fn uncommented(line: &str) -> &str {
    line.split(" #").next().unwrap_or(line).trim_end()
}

/// The examples of a page of help, without their comments.
fn of_help(help: &str) -> Vec<String> {
    let (_, examples) = help.split_once("Examples:\n").expect("examples");
    let lines = examples.lines().map(str::trim);
    let shown = lines.filter(|line| line.starts_with("vkpt "));
    shown
        .map(|line| line.split("  ").next().unwrap_or(line).to_owned())
        .collect()
}

fn cheaper(line: &str) -> String {
    let shortened = |line: String, (long, short): &(&str, &str)| line.replace(long, short);
    let line = CHEAPER.iter().fold(line.to_owned(), shortened);
    let is_large = line.contains("scenes/") || line.contains("docs/");
    let line = match is_large && !line.contains("--size") {
        true => format!("{line} --size 8x6"),
        false => line,
    };
    match line.starts_with("vkpt converge") && !line.contains("--time") {
        true => format!("{line} --time 0.2"),
        false => line,
    }
}

/// A folder with all files that the lines name, with vkpt and the programs that it is piped to in its `bin`.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    for name in ["bin", "shots", "pictures", "out"] {
        fs::create_dir(at.join(name)).expect("a folder");
    }
    for name in [
        "scene.scn",
        "shots/1.txt",
        "shots/2.txt",
        "pictures/ball.txt",
    ] {
        fs::write(at.join(name), SCENE).expect("a scene");
    }
    // tests/commands/tutorial.rs reads those of docs/tutorial/ themselves.
    for name in names(&root().join("docs/tutorial")) {
        if name.ends_with(".txt") {
            fs::write(at.join(name), SCENE).expect("a scene");
        }
    }
    let mut model = Model::seen_from([0.0, 0.0, 5.0], 0.5);
    model.document["cameras"][0]["name"] = "Front".into();
    model.cuboid([-1.0; 3], [1.0; 3], lamp(1.0));
    fs::write(at.join("model.glb"), model.glb()).expect("a model");
    for name in ["scenes", "docs"] {
        symlink(root().join(name), at.join(name)).expect("a link");
    }
    let bin = at.join("bin");
    program(
        &bin,
        "vkpt",
        &format!("exec {} \"$@\"", env!("CARGO_BIN_EXE_vkpt")),
    );
    program(&bin, "make-scene", "cat scene.scn");
    program(&bin, "display", "cat > /dev/null");
    program(&bin, "jq", "cat > /dev/null");
    let classes = "light:EL,light:ED.*L,light:EDS+L";
    for (name, seed) in [("a", 0), ("b", 1), ("r", 2), ("other", 3), ("scene", 4)] {
        made(
            at,
            &format!("scene.scn --seed {seed} --aov stderr,{classes} -o {name}.exr"),
        );
    }
    fs::remove_file(at.join("scene-stderr.exr")).expect("standard errors");
    made(at, "scene.scn --aov stderr --spp 256 -o scene.exr");
    for (name, samples) in [("a", "0..512"), ("b", "512..1024")] {
        made(at, &format!("scene.scn --samples {samples} -o {name}.vkpt"));
    }
    made(at, "test pictures --bless");
    folder
}

fn made(folder: &Path, line: &str) {
    let run = words(folder, &format!("{line} --quiet"));
    assert_eq!(run.code, Some(0), "{line}: {}", run.err);
}

/// Runs a line in a copy of the folder; returns its output if it fails.
fn failure(folder: &Path, line: &str) -> Option<String> {
    let copy = tempfile::tempdir().expect("a folder");
    let all = [&folder.join("."), copy.path()];
    let copied = Command::new("cp").arg("-r").args(all).status();
    assert!(copied.is_ok_and(|status| status.success()));
    // It exists already for all commands except the one that writes it.
    if !line.starts_with("vkpt init") {
        fs::write(copy.path().join("scene.txt"), SCENE).expect("a scene");
    }
    let path = std::env::var("PATH").expect("PATH");
    let path = format!("{}:{path}", folder.join("bin").display());
    let mut shell = Command::new("timeout");
    let shell = shell.args(["60", "bash", "-o", "pipefail", "-c", &cheaper(line)]);
    let run = finish(
        shell
            .current_dir(copy.path())
            .env("PATH", path)
            .env("NO_COLOR", "1"),
    );
    (run.code != Some(0)).then(|| format!("{line}: {:?}, {}{}", run.code, run.out, run.err))
}

#[test]
fn every_command_that_is_shown_succeeds() {
    if without_vulkan() {
        return;
    }
    let folder = folder();
    let help = COMMANDS.map(|command| words(folder.path(), format!("{command} --help").trim()).out);
    let pages = pages();
    let shown = pages.iter().flat_map(|page| of_page(page));
    let claims = of_text(README);
    assert!(claims.len() > 3, "{claims:?}");
    let lines: Vec<String> = shown
        .chain(claims)
        .chain(help.iter().flat_map(|help| of_help(help)))
        .collect();
    assert!(lines.len() > 90, "{lines:#?}");
    let failed: Vec<String> = lines
        .iter()
        .filter_map(|line| failure(folder.path(), line))
        .collect();
    assert!(failed.is_empty(), "{}", failed.join("\n\n"));
}

#[test]
fn lines_are_found_and_failures_seen() {
    let page = "text\n```sh\nvkpt a.txt   # said\nmake | vkpt - -o -\nls\n```\nvkpt not\n```yaml\n      - run: vkpt test p\n```\n";
    assert_eq!(
        of_page(page),
        ["vkpt a.txt", "make | vkpt - -o -", "vkpt test p"]
    );
    assert_eq!(
        of_text("`vkpt a.txt --spp 4`, `vkpt merge` or `ls -l -a`\n```\nvkpt b.txt -o c\n```\n"),
        ["vkpt a.txt --spp 4"]
    );
    let help = "Options:\n\nExamples:\n  vkpt init              said\n  vkpt a.txt --time 60\n";
    assert_eq!(of_help(help), ["vkpt init", "vkpt a.txt --time 60"]);
    assert_eq!(cheaper("vkpt a.txt --time 60"), "vkpt a.txt --time 0.2");
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("bin")).expect("a folder");
    program(
        &folder.path().join("bin"),
        "vkpt",
        &format!("exec {} \"$@\"", env!("CARGO_BIN_EXE_vkpt")),
    );
    let wrong = failure(folder.path(), "vkpt scene.scn --nonsense | cat").expect("a failure");
    assert!(wrong.contains("--nonsense"), "{wrong}");
}

#[test]
fn the_workflow_is_the_one_of_its_page() {
    let workflow = include_str!("../../docs/ci/pictures.yml");
    let page = include_str!("../../docs/ci.md");
    assert!(page.contains(&format!("```yaml\n{workflow}```\n")));
    assert!(workflow.lines().count() <= 12);
}

#[test]
fn help_of_each_command_has_exit_codes_and_examples() {
    let folder = tempfile::tempdir().expect("a folder");
    for command in COMMANDS.iter().filter(|command| !command.is_empty()) {
        let words: Vec<&str> = command.split(' ').chain(["--help"]).collect();
        let help = run(folder.path(), &words).out;
        assert!(help.contains("Examples:\n  vkpt "), "{command}");
        // Of `farm` those of its systems count.
        let has_codes = help.contains("Exit codes:\n    0  ");
        assert!(has_codes || *command == "farm", "{command}");
        assert!(
            help.lines().all(|line| line.chars().count() <= 100),
            "{command}"
        );
    }
}
