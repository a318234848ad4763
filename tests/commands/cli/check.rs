//! `vkpt check`: selection, table, report, exit codes.

use insta::assert_snapshot;

use super::program::{folder, names, run, shown, without_vulkan};

#[test]
fn an_unknown_case_is_a_mistake_of_the_command_line() {
    let folder = folder("");
    for name in ["alp", "", "alpha/ggx/7"] {
        let ran = run(folder.path(), &["check", "--case", name]);
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{name}");
        for group in ["alpha", "furnace", "mesh"] {
            assert!(ran.err.contains(group), "{}", ran.err);
        }
    }
}

#[test]
fn a_case_is_printed_and_reported() {
    if without_vulkan() {
        return;
    }
    let folder = folder("");
    let arguments = [
        "check",
        "--quick",
        "--case",
        "camera/one-pixel",
        "--json",
        "check.json",
        "--html",
        "check.html",
    ];
    let ran = run(folder.path(), &arguments);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{}", ran.out);
    assert!(
        ran.out.contains("one-pixel") && ran.out.contains("1 case, none fails"),
        "{}",
        ran.out
    );
    let text = std::fs::read_to_string(folder.path().join("check.json")).expect("a report");
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["cases"][0]["name"], "camera/one-pixel");
    assert_eq!(
        (&json["passed"], &json["quick"]),
        (&true.into(), &true.into())
    );
    let page = std::fs::read_to_string(folder.path().join("check.html")).expect("a page");
    for words in [
        "The only case is within its bounds.",
        "camera/one-pixel",
        "--html",
    ] {
        assert!(page.contains(words), "{words}");
    }
    // Device, cpu-f64 and difference.
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 3);
    let quiet = run(
        folder.path(),
        &["check", "--case", "light/sky-alone", "--quiet"],
    );
    assert_eq!(
        (quiet.code, quiet.out.as_str(), quiet.err.as_str()),
        (Some(0), "", "")
    );
}

/// Before any case runs: no case is reported.
#[test]
fn reports_that_cannot_be_written_are_refused_before_the_work() {
    let folder = folder("");
    let lines = [
        ("--html none/r.html", 5),
        ("--html .", 5),
        ("--json r --html ./r", 2),
        ("--html", 2),
    ];
    let messages = lines.map(|(reports, code)| {
        let line = format!("check --case camera/one-pixel {reports}");
        let arguments: Vec<&str> = line.split(' ').collect();
        let ran = run(folder.path(), &arguments);
        assert_eq!((ran.code, ran.out.as_str()), (Some(code), ""), "{line}");
        assert_eq!(names(folder.path()), ["scene.scn"], "{line}");
        shown(&arguments, &ran.err)
    });
    assert_snapshot!(messages.concat());
}
