//! Files that are written: through links, and to devices and pipes.

use std::fs;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;

use insta::assert_snapshot;

use super::program::{MESH, MESHED, SCENE, folder, names, shell, shown, words};

/// All renderings here give the same picture.
const RENDER: &str = "scene.scn --device cpu-f32 --spp 2 --quiet";

/// Each line leaves only the whole picture in `a`; a device or a link that it wrote to is there as before.
#[test]
fn files_that_are_already_open_are_written_to() {
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

/// Text for people is not on stdout where a file is, under any name; existing files stay.
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
    // A device takes any number of outputs, and does not count as stdout because stdout goes there too.
    let null = format!("$VKPT {loud} -o /dev/null --format exr --json /dev/null > /dev/null");
    let ran = shell(folder.path(), &null);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
}

#[test]
fn links_stay_and_lead_to_the_written_file() {
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
        "error: cannot write circle.exr: its links form a cycle\n"
    );
    let twice = words(
        folder.path(),
        &format!("{RENDER} -o new.exr --json in/new.exr"),
    );
    assert_eq!(twice.code, Some(2), "{}", twice.err);
}

/// Files next to a picture or a scene have no place next to a device.
#[test]
fn nothing_is_written_beside_a_device() {
    let folder = folder(MESHED);
    fs::write(folder.path().join("m.ply"), MESH).expect("a mesh");
    let lines = [
        format!("{RENDER} -o /dev/null --format exr --aov stderr"),
        "export scene.scn --to mitsuba -o /dev/null".to_owned(),
    ];
    let messages = lines.map(|line| {
        let ran = words(folder.path(), &line);
        assert_eq!(ran.code, Some(2), "{line}: {}", ran.err);
        shown(&line.split(' ').collect::<Vec<_>>(), &ran.err)
    });
    assert_snapshot!(messages.concat());
    let kernels = "explain scene.scn --integrator bidirectional --spirv /dev/null";
    assert_eq!(words(folder.path(), kernels).code, Some(0));
    assert!(!Path::new("/dev/null-2").exists());
}
