//! `vkpt test`: scenes against the pictures kept next to them.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use roxmltree::Document;
use vkpt::image::read;

use super::program::{SCENE, folder, names, shown, words};

/// Two scenes, one below.
fn two() -> tempfile::TempDir {
    let folder = folder("");
    fs::remove_file(folder.path().join("scene.scn")).expect("a file");
    fs::create_dir_all(folder.path().join("p/in")).expect("folders");
    fs::write(folder.path().join("p/a.txt"), SCENE).expect("a scene");
    fs::write(
        folder.path().join("p/in/b.scn"),
        SCENE.replace("1 1 1", "2 1 1"),
    )
    .expect("a scene");
    folder
}

fn bytes(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

#[test]
fn kept_pictures_are_made_again() {
    let folder = two();
    let at = folder.path();
    let missing = words(at, "test p --spp 4");
    assert_eq!((missing.code, missing.err.as_str()), (Some(1), ""));
    assert!(missing.out.contains("FAILED  a.txt"), "{}", missing.out);
    let printed =
        "p/in/b.expected.exr does not exist: use --bless to keep the picture rendered now";
    assert!(missing.out.contains(printed), "{}", missing.out);
    assert!(!at.join("test-results").exists());

    let blessed = words(at, "test p --spp 4 --bless");
    assert_eq!(blessed.code, Some(0), "{}", blessed.err);
    assert!(blessed.out.contains("kept    in/b.scn"), "{}", blessed.out);
    let plain = words(at, "p/a.txt --spp 4 --device cpu-f32 --quiet -o plain.exr");
    assert_eq!(plain.code, Some(0));
    let [kept, plain] =
        ["p/a.expected.exr", "plain.exr"].map(|name| read(&at.join(name)).expect(name));
    assert_eq!(kept.film, plain.film);
    // The same file wherever the folder is.
    assert!(kept.notes.contains("scene: a.txt\n"), "{}", kept.notes);

    let same = words(at, "test p --spp 4 --junit r.xml");
    assert_eq!(
        (same.code, same.err.as_str()),
        (Some(0), ""),
        "{}",
        same.out
    );
    assert!(same.out.starts_with("same    a.txt  "), "{}", same.out);
    assert!(same.out.ends_with(": all passed\n"), "{}", same.out);
    let text = fs::read_to_string(at.join("r.xml")).expect("a report");
    let xml = Document::parse(&text).expect("XML");
    assert_eq!(xml.root_element().attribute("tests"), Some("2"));
    assert_eq!(xml.root_element().attribute("failures"), Some("0"));
    let cases = xml.descendants().filter(|n| n.has_tag_name("testcase"));
    let cases: Vec<_> = cases
        .map(|n| n.attribute("name").expect("a name"))
        .collect();
    assert_eq!(cases, ["a.txt", "in/b.scn"]);
    // Nothing is blessed that is as it was.
    let before = bytes(at, "p/a.expected.exr");
    let again = words(at, "test p --spp 4 --bless --quiet");
    assert_eq!((again.code, again.out.as_str()), (Some(0), ""));
    assert_eq!(bytes(at, "p/a.expected.exr"), before);
}

#[test]
fn a_picture_that_differs_is_shown() {
    let folder = two();
    let at = folder.path();
    assert_eq!(words(at, "test p --spp 4 --bless").code, Some(0));
    fs::write(at.join("p/in/b.scn"), SCENE.replace("1 1 1", "2 1.001 1")).expect("a scene");
    // This folder has no pictures so far.
    let run = words(
        at,
        "test p --spp 4 --quiet --junit r.xml --html test-results/index.html",
    );
    assert_eq!((run.code, run.err.as_str()), (Some(1), ""), "{}", run.out);
    assert!(run.out.starts_with("DIFFERS in/b.scn  "), "{}", run.out);
    for printed in [
        "of 48 pixels differ",
        "wrote test-results/in/b.actual.exr, test-results/in/b.difference.png",
    ] {
        assert!(run.out.contains(printed), "{}", run.out);
    }
    let shown = names(&at.join("test-results/in"));
    assert_eq!(shown, ["b.actual.exr", "b.difference.png"]);
    let text = fs::read_to_string(at.join("r.xml")).expect("a report");
    let xml = Document::parse(&text).expect("XML");
    let failure = xml
        .descendants()
        .find(|n| n.has_tag_name("failure"))
        .expect("a failure");
    assert!(
        failure
            .attribute("message")
            .expect("words")
            .contains("pixels differ")
    );
    assert!(failure.text().expect("words").contains("b.actual.exr"));
    let page = bytes(at, "test-results/index.html");
    let page = String::from_utf8(page).expect("a page");
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 3);
    for printed in ["same to the bit", "href=\"#in/b.scn\"", "1 failed"] {
        assert!(page.contains(printed), "{printed}");
    }
    fs::remove_file(at.join("test-results/index.html")).expect("a page");
    // Within the tolerance, and not within less.
    let close = words(at, "test p --spp 4 --max-relmse 1e-3");
    assert_eq!(close.code, Some(0), "{}", close.out);
    assert!(close.out.contains("close   in/b.scn"), "{}", close.out);
    assert_eq!(words(at, "test p --spp 4 --max-relmse 1e-12").code, Some(1));
    // Other settings that it was made from are reported: a lamp that fills its pixels has no noise.
    let other = words(at, "test p --spp 8 --max-depth 3 --size 4x3");
    assert_eq!(other.code, Some(1));
    for printed in [
        "it has 4×3 pixels at 0,0 of 4×3; expected 8×6",
        "spp is 4 in the kept picture and 8 in this one",
        "max-depth is none in the kept picture and 3 in this one",
    ] {
        assert!(other.out.contains(printed), "{}", other.out);
    }
    let blessed = words(at, "test p --spp 4 --bless");
    assert!(blessed.out.contains("kept    in/b.scn"), "{}", blessed.out);
    assert!(
        blessed.out.contains(", replaces another"),
        "{}",
        blessed.out
    );
    assert_eq!(words(at, "test p --spp 4").code, Some(0));
}

/// One bad scene leaves the others, and a picture whose scene is gone is no test that passes.
#[test]
fn scenes_and_pictures_that_cannot_be_compared_are_failures() {
    let folder = two();
    let at = folder.path();
    assert_eq!(words(at, "test p --spp 2 --bless").code, Some(0));
    fs::write(at.join("p/a.txt"), "screen 8 6\nspher 0 0 0 1\n").expect("a scene");
    fs::write(at.join("p/gone.expected.exr"), "").expect("a file");
    let run = words(at, "test p --spp 2 --junit -");
    assert_eq!(run.code, Some(1));
    for printed in [
        "FAILED  a.txt",
        "FAILED  gone.expected.exr",
        "no scene next to it",
        "same    in/b.scn",
    ] {
        assert!(run.err.contains(printed), "{}", run.err);
    }
    assert!(run.err.contains("spher"), "{}", run.err);
    let xml = Document::parse(&run.out).expect("XML");
    assert_eq!(xml.root_element().attribute("errors"), Some("2"));
    // A picture that can't be read is no reason to fail for ever.
    fs::write(at.join("p/in/b.expected.exr"), "no picture").expect("a file");
    let run = words(at, "test p/in --spp 2");
    assert_eq!(run.code, Some(1));
    assert!(run.out.contains("FAILED  b.scn"), "{}", run.out);
    assert_eq!(words(at, "test p/in --spp 2 --bless").code, Some(0));
    assert_eq!(words(at, "test p/in --spp 2").code, Some(0));
}

#[test]
fn folders_without_scenes_are_mistakes_of_the_command_line() {
    let folder = folder("");
    fs::create_dir(folder.path().join("empty")).expect("a folder");
    let lines = [
        "test none",
        "test empty",
        "test empty --bless --max-relmse 1",
    ];
    let messages = lines.map(|line| {
        let run = words(folder.path(), line);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{line}");
        shown(&line.split(' ').collect::<Vec<_>>(), &run.err)
    });
    assert_snapshot!(messages.concat());
}
