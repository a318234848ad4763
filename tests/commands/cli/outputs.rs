//! Files that are written: through links, to devices and pipes, and never over what is read.

use std::fs;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;

use super::program::{
    MESH, MESHED, Run, SCENE, command, finish, folder, names, run, shell, without_vulkan,
};

/// What all renderings here are: the same picture.
const RENDER: &str = "scene.scn --device cpu-f32 --spp 2 --quiet";

/// Every file in a folder, with its content.
fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let files = names(folder)
        .into_iter()
        .map(|name| (folder.join(&name), name));
    let files = files.filter(|(path, _)| path.is_file());
    files
        .map(|(path, name)| (name, fs::read(path).expect("a file")))
        .collect()
}

fn words(folder: &Path, line: &str) -> Run {
    run(folder, &line.split(' ').collect::<Vec<_>>())
}

/// Each line leaves the whole picture and nothing else in `a`; a device or a link that it wrote to is there as before.
#[test]
fn what_is_open_already_is_written_to() {
    let folder = folder(SCENE);
    words(folder.path(), &format!("{RENDER} -o expected.png"));
    let picture = fs::read(folder.path().join("expected.png")).expect("a picture");
    let png = format!("$VKPT {RENDER} --format png");
    let rows = [
        format!("{png} -o /dev/stdout > a"),
        format!("{png} -o /dev/fd/1 > a"),
        format!("{png} -o a > a"),
        format!("{png} -o /dev/stdout | cat > a"),
        format!("{png} -o /dev/stderr 2> a"),
        format!("{png} -o a 2> a"),
        format!("{png} -o /dev/fd/3 3> a"),
        format!("{png} -o /dev/fd/3 3> >(cat > a); code=$?; wait $!; exit $code"),
        format!("{png} -o >(cat > a); code=$?; wait $!; exit $code"),
        format!("mkfifo f; cat f > a & {png} -o f; code=$?; wait; [ -p f ] && rm f && exit $code"),
        format!("ln -s /dev/stdout l; {png} -o l > a && [ -L l ] && rm l"),
    ];
    for line in rows {
        let ran = shell(folder.path(), &line);
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{line}");
        assert!(
            fs::read(folder.path().join("a")).expect("a") == picture,
            "{line}"
        );
        assert_eq!(names(folder.path()), ["a", "expected.png", "scene.scn"]);
        fs::remove_file(folder.path().join("a")).expect("removed");
    }
    assert!(Path::new("/dev/stdout").is_symlink());
    let null = fs::metadata("/dev/null").expect("a device");
    assert!(null.file_type().is_char_device());
}

/// Text for people is not on stdout where a file is, by whatever name; what stood there before stays.
#[test]
fn stdout_by_another_name_is_still_stdout() {
    let folder = folder(SCENE);
    let loud = RENDER.replace(" --quiet", "");
    let line = format!("{{ printf before; $VKPT {loud} -o a.exr --json /dev/stdout; }} > a");
    let ran = shell(folder.path(), &line);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.err.contains("wrote   a.exr"), "{}", ran.err);
    let text = fs::read_to_string(folder.path().join("a")).expect("a text");
    let json = text.strip_prefix("before").expect("what stood there");
    assert!(serde_json::from_str::<serde_json::Value>(json).is_ok());
    let twice = format!("$VKPT {RENDER} -o a --format exr --json - > a");
    let ran = shell(folder.path(), &twice);
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("two outputs would be written to stdout"));
    // A device takes any number of outputs, and is not stdout because stdout goes there too.
    let null = format!("$VKPT {loud} -o /dev/null --format exr --json /dev/null > /dev/null");
    let ran = shell(folder.path(), &null);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
}

#[test]
fn links_stay_and_lead_to_what_is_written() {
    let folder = folder(SCENE);
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("in")).expect("a folder");
    fs::write(path("in/old.exr"), "old").expect("a file");
    fs::set_permissions(path("in/old.exr"), fs::Permissions::from_mode(0o640)).expect("mode");
    for (link, to) in [
        ("chain.exr", "in/link"),
        ("in/link", "old.exr"),
        ("new.exr", "in/new.exr"),
        ("circle.exr", "circle.exr"),
    ] {
        symlink(to, path(link)).expect("a link");
    }
    for (link, file) in [("chain.exr", "in/old.exr"), ("new.exr", "in/new.exr")] {
        let ran = words(folder.path(), &format!("{RENDER} -o {link}"));
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{link}");
        assert!(path(link).is_symlink() && !path(file).is_symlink());
        let bytes = fs::read(path(file)).expect("a picture");
        assert!(bytes.starts_with(b"\x76\x2f\x31\x01"), "{file}");
    }
    assert!(path("in/link").is_symlink());
    let mode = fs::metadata(path("in/old.exr"))
        .expect("a file")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o640);
    let ran = words(folder.path(), &format!("{RENDER} -o circle.exr"));
    assert_eq!(ran.code, Some(5));
    assert_eq!(
        ran.err,
        "error: cannot write circle.exr: its links lead in a circle\n"
    );
    let twice = words(
        folder.path(),
        &format!("{RENDER} -o new.exr --json in/new.exr"),
    );
    assert_eq!(twice.code, Some(2), "{}", twice.err);
}

/// By every name that leads to it; nothing is touched.
#[test]
fn nothing_that_is_read_is_written_over() {
    let folder = folder(&MESHED.replace("m.ply", "in/m.ply"));
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("in")).expect("a folder");
    fs::write(path("in/m.ply"), MESH).expect("a mesh");
    fs::copy(path("scene.scn"), path("as.png")).expect("a scene");
    fs::copy(path("scene.scn"), path("as-stderr.exr")).expect("a scene");
    fs::hard_link(path("scene.scn"), path("hard.exr")).expect("a link");
    symlink("scene.scn", path("soft.exr")).expect("a link");
    for seed in [1, 2] {
        let line = format!("{RENDER} --seed {seed} --aov stderr -o {seed}.exr -o {seed}.png");
        assert_eq!(words(folder.path(), &line).code, Some(0));
    }
    let by = "--device cpu-f32 --spp 4294967295";
    let rows = [
        (
            format!("scene.scn {by} --json scene.scn"),
            "scene.scn",
            "the scene",
        ),
        (
            format!("scene.scn {by} --json in/../scene.scn"),
            "in/../scene.scn",
            "the scene scene.scn",
        ),
        (
            format!("scene.scn {by} -o hard.exr"),
            "hard.exr",
            "the scene scene.scn",
        ),
        (
            format!("soft.exr {by} -o hard.exr"),
            "hard.exr",
            "the scene soft.exr",
        ),
        (
            format!("scene.scn {by} -o a.png -o soft.exr"),
            "soft.exr",
            "the scene scene.scn",
        ),
        (format!("as.png {by}"), "as.png", "the scene"),
        (
            format!("as-stderr.exr {by} -o as.exr --aov stderr"),
            "as-stderr.exr",
            "the scene",
        ),
        (
            format!("scene.scn {by} --json in/m.ply"),
            "in/m.ply",
            "a mesh of the scene",
        ),
        (
            format!("- {by} --json scene.scn"),
            "scene.scn",
            "the scene <stdin>",
        ),
        (
            format!("converge scene.scn {by} --svg scene.scn"),
            "scene.scn",
            "the scene",
        ),
        (
            format!("converge scene.scn {by} --reference 1.exr --csv 1.exr"),
            "1.exr",
            "the reference",
        ),
        (
            format!("converge scene.scn {by} --reference 1.exr --csv 1-stderr.exr"),
            "1-stderr.exr",
            "its standard errors",
        ),
        (
            "compare 1.png 2.png --heatmap 1.png".to_owned(),
            "1.png",
            "a picture to compare",
        ),
        (
            "explain scene.scn --spirv in/m.ply".to_owned(),
            "in/m.ply",
            "a mesh of the scene",
        ),
        (
            "export scene.scn --to mitsuba -o scene.scn".to_owned(),
            "scene.scn",
            "the scene",
        ),
    ];
    let before = [folder.path(), &path("in")].map(contents);
    for (line, to, what) in rows {
        let ran = shell(folder.path(), &format!("$VKPT {line} < scene.scn"));
        assert_eq!(ran.code, Some(2), "{line}: {}", ran.err);
        let said = format!("error: {to} would be overwritten: it is {what}; give ");
        assert!(ran.err.contains(&said), "{line}: {}", ran.err);
        let after = [folder.path(), &path("in")].map(contents);
        assert!(before == after, "{line}");
    }
}

/// What stands beside a picture or a scene has no place beside a device.
#[test]
fn nothing_is_written_beside_a_device() {
    let folder = folder(MESHED);
    fs::write(folder.path().join("m.ply"), MESH).expect("a mesh");
    for (line, said) in [
        (
            format!("{RENDER} -o /dev/null --format exr --aov stderr"),
            "no place beside it: add -o FILE",
        ),
        (
            "export scene.scn --to mitsuba -o /dev/null".to_owned(),
            "/dev/null has no place beside it: use -o FILE",
        ),
    ] {
        let ran = words(folder.path(), &line);
        assert_eq!(ran.code, Some(2), "{line}: {}", ran.err);
        assert!(ran.err.contains(said), "{line}: {}", ran.err);
    }
    let kernels = "explain scene.scn --integrator bidirectional --spirv /dev/null";
    assert_eq!(words(folder.path(), kernels).code, Some(0));
    assert!(!Path::new("/dev/null-2").exists());
}

/// Found out before the first of 2³² samples, of the default names too: nobody can make a file in /proc.
#[test]
fn a_folder_that_takes_no_files_is_told_before_the_work() {
    let folder = folder(SCENE);
    let scene = folder.path().join("scene.scn");
    let scene = scene.to_str().expect("a name");
    words(folder.path(), &format!("{RENDER} -o a.png"));
    let picture = folder.path().join("a.png");
    let picture = picture.to_str().expect("a name");
    let endless = ["--device", "cpu-f32", "--spp", "4294967295"];
    let mut rows: Vec<(Vec<&str>, &str)> = vec![
        ([&[scene][..], &endless].concat(), "scene.png"),
        ([&[scene, "-o", "b.hdr"][..], &endless].concat(), "b.hdr"),
        (
            [&["converge", scene, "--csv", "c.csv"][..], &endless].concat(),
            "c.csv",
        ),
        (
            vec!["compare", picture, picture, "--heatmap", "d.png"],
            "d.png",
        ),
        (vec!["explain", scene, "--spirv", "e.spv"], "e.spv"),
        (vec!["export", scene, "--to", "mitsuba"], "scene.xml"),
        (vec!["check", "--json", "f.json"], "f.json"),
    ];
    if !without_vulkan() {
        rows.push((vec!["doctor", "--json", "g.json"], "g.json"));
    }
    for (arguments, name) in rows {
        let ran = finish(command(Path::new("/proc"), &arguments).current_dir("/proc"));
        assert_eq!(ran.code, Some(5), "{arguments:?}: {}", ran.err);
        let said = format!("error: cannot write {name}: ");
        assert!(ran.err.starts_with(&said), "{arguments:?}: {}", ran.err);
        assert!(!ran.err.contains(".vkpt-"), "{}", ran.err);
        assert_eq!(ran.out, "", "{arguments:?}");
    }
}

/// Its folder would let another file take its place. Root may write it, and does.
#[test]
fn a_file_that_may_not_be_written_is_not_replaced() {
    let folder = folder(SCENE);
    let path = folder.path().join("a.exr");
    fs::write(&path, "old").expect("a file");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).expect("mode");
    let may = fs::OpenOptions::new().write(true).open(&path).is_ok();
    let ran = words(folder.path(), &format!("{RENDER} -o a.exr"));
    assert_eq!(ran.code, Some(if may { 0 } else { 5 }), "{}", ran.err);
    let kept = fs::read(&path).expect("a file") == b"old";
    assert_eq!(kept, !may);
    assert_eq!(names(folder.path()), ["a.exr", "scene.scn"]);
}

#[test]
fn names_that_no_file_can_have_are_told_before_the_work() {
    let folder = folder(SCENE);
    let (most, more) = ("n".repeat(251) + ".exr", "n".repeat(252) + ".exr");
    let endless = RENDER.replace("--spp 2", "--spp 4294967295");
    let picture = format!("{endless} -o {most} --aov stderr");
    for (line, said) in [
        (format!("{endless} -o {more}"), "too long"),
        (picture, "n-stderr.exr: File name too long"),
        (
            format!("{endless} --json none/"),
            "cannot write none/: is no name of a file",
        ),
        (format!("{endless} --json "), "is no name of a file"),
        (
            format!("{endless} --json scene.scn/a"),
            "cannot write scene.scn/a: ",
        ),
    ] {
        let ran = words(folder.path(), &line);
        assert_eq!(ran.code, Some(5), "{}: {}", line, ran.err);
        assert!(ran.err.contains(said), "{}: {}", line, ran.err);
        assert_eq!(names(folder.path()), ["scene.scn"]);
    }
    let ran = words(folder.path(), &format!("{RENDER} -o {most}"));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
}
