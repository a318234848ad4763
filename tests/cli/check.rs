//! `vkpt check`: selection, table, report, exit codes.

use super::program::{folder, run, without_vulkan};

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
fn a_case_is_told_and_reported() {
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
    let quiet = run(
        folder.path(),
        &["check", "--case", "light/sky-alone", "--quiet"],
    );
    assert_eq!(
        (quiet.code, quiet.out.as_str(), quiet.err.as_str()),
        (Some(0), "", "")
    );
}
