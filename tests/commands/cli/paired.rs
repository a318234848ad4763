//! `vkpt compare --paired`: the table, and how it ends.

use insta::assert_snapshot;

use super::program::{folder, names, run, shown, without_vulkan};

const LIT: &str = "screen 8 6\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

#[test]
fn a_table_goes_to_stdout_and_leaves_no_file() {
    if without_vulkan() {
        return;
    }
    let folder = folder(LIT);
    let compared = run(
        folder.path(),
        &["compare", "--paired", "scene.scn", "--spp", "3"],
    );
    assert_eq!((compared.code, compared.err.as_str()), (Some(0), ""));
    assert!(
        compared
            .out
            .starts_with("scene.scn: 8×6, 3 samples per pixel, seed 0\n")
    );
    for word in [
        "GPU – cpu-f64",
        "stay together",
        "of 144 paths equal to the bit",
    ] {
        assert!(compared.out.contains(word), "{word}: {}", compared.out);
    }
    assert_eq!(names(folder.path()), ["scene.scn"]);
    let arguments = [
        "compare",
        "--paired",
        "scene.scn",
        "--crop",
        "1,1,3,3",
        "--quiet",
    ];
    let quiet = run(folder.path(), &arguments);
    assert_eq!(
        (quiet.code, quiet.out + &quiet.err),
        (Some(0), String::new())
    );
}

#[test]
fn renderings_that_cannot_be_compared_are_refused() {
    let lines = [
        ("compare", 2),
        ("compare --paired none.scn", 3),
        ("compare --paired scene.scn --device cpu-f64", 2),
        ("compare --paired scene.scn --crop 0,0,9,6", 2),
    ];
    let messages = lines.map(|(line, code)| {
        let arguments: Vec<&str> = line.split(' ').collect();
        let refused = run(folder(LIT).path(), &arguments);
        assert_eq!(refused.code, Some(code), "{line}: {}", refused.err);
        shown(&arguments, &refused.err)
    });
    assert_snapshot!(messages.concat());
    if !without_vulkan() {
        let arguments = ["compare", "--paired", "scene.scn", "--device", "99"];
        assert_eq!(run(folder(LIT).path(), &arguments).code, Some(4));
    }
}
