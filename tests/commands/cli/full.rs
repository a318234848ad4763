//! Full disks: existing files stay whole, and no temporary file is left.
//!
//! A quota ends a write as a full disk does, by an error of the same calls; the system reports one at the latest when the
//! file is brought to the disk, before it takes the old one's place.

use std::fs;

use super::program::{Run, SCENE, folder, names, shell, words};
use crate::common::needs::Need;

/// Whose noise takes more than that disk.
const LARGE: &str = "screen 200 200\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

const RENDER: &str = "scene.scn --device cpu-f32 --spp 2 --quiet";

/// Runs a line in a folder with the folder `disk`, of 16 KiB and with `old` in `disk/a.exr`; returns the file's text
/// afterwards,
/// and the names in `disk`. Only the line's processes see the disk.
fn on_a_small_disk(line: &str) -> (Run, String) {
    let folder = folder(SCENE);
    fs::create_dir(folder.path().join("disk")).expect("a folder");
    fs::write(folder.path().join("large.scn"), LARGE).expect("a scene");
    let mount = "mount -t tmpfs -o size=16k none disk && printf old > disk/a.exr";
    let after = "cp disk/a.exr after; ls -A disk > names";
    let inside = format!("{mount} && {{ {line}; code=$?; {after}; exit $code; }}");
    let ran = shell(
        folder.path(),
        &format!("unshare --map-root-user --mount bash -c '{inside}'"),
    );
    let left = fs::read_to_string(folder.path().join("names")).expect("names");
    let after = fs::read_to_string(folder.path().join("after")).expect("the old file, in ASCII");
    (ran, format!("{left}{after}"))
}

/// A mount that programs without privileges may make: `mount(8)` in their own namespace.
fn cannot_mount() -> bool {
    let mount = || {
        let folder = folder(SCENE);
        let ran = shell(
            folder.path(),
            "unshare --map-root-user --mount mount -t tmpfs none .",
        );
        match ran.code {
            Some(0) => Ok(()),
            _ => Err(ran.err),
        }
    };
    Need::Mounts.find(mount).is_none()
}

/// Full from the start, and full half-way through the picture.
#[test]
fn a_full_disk_keeps_its_files() {
    if cannot_mount() {
        return;
    }
    let fill = "dd if=/dev/zero of=disk/rest bs=1k 2> /dev/null";
    let large = RENDER.replace("scene.scn", "large.scn");
    for (line, left) in [
        (
            format!("{fill}; $VKPT {RENDER} -o disk/a.exr"),
            "a.exr\nrest\nold",
        ),
        (format!("$VKPT {large} -o disk/a.exr"), "a.exr\nold"),
    ] {
        let (ran, after) = on_a_small_disk(&line);
        let message = "error: cannot write disk/a.exr: No space left on device";
        assert_eq!(ran.code, Some(5), "{line}: {}", ran.err);
        assert!(ran.err.starts_with(message), "{line}: {}", ran.err);
        assert_eq!(after, left, "{line}");
    }
}

/// The picture that has room is written, and the error names the other.
#[test]
fn a_full_disk_costs_no_picture_on_another() {
    if cannot_mount() {
        return;
    }
    let fill = "dd if=/dev/zero of=disk/rest bs=1k 2> /dev/null";
    let line = format!("{fill}; $VKPT {RENDER} -o disk/a.exr -o a.png");
    let (ran, after) = on_a_small_disk(&line);
    assert_eq!((ran.code, after.as_str()), (Some(5), "a.exr\nrest\nold"));
    let line = format!("{fill}; $VKPT {RENDER} -o disk/a.exr -o a.png; [ -s a.png ]");
    assert_eq!(on_a_small_disk(&line).0.code, Some(0));
}

/// Reported before the first of 2³² samples.
#[test]
fn a_folder_on_a_disk_that_is_only_read_is_refused() {
    if cannot_mount() {
        return;
    }
    let endless = RENDER.replace("--spp 2", "--spp 4294967295");
    for name in ["a.exr", "new.exr"] {
        let (ran, after) = on_a_small_disk(&format!(
            "mount -o remount,ro disk; $VKPT {endless} -o disk/{name}"
        ));
        assert_eq!(ran.code, Some(5), "{}", ran.err);
        let message = format!("error: cannot write disk/{name}: ");
        assert!(ran.err.starts_with(&message), "{}", ran.err);
        assert!(ran.err.contains("Read-only file system"), "{}", ran.err);
        assert_eq!(after, "a.exr\nold");
    }
}

/// Beyond `ulimit -f` a write fails like any other.
#[test]
fn a_file_beyond_the_limit_is_an_error_and_no_kill() {
    let folder = folder(SCENE);
    fs::write(folder.path().join("a.exr"), "old").expect("a file");
    let line = format!("ulimit -f 0; exec $VKPT {RENDER} -o a.exr");
    let ran = shell(folder.path(), &line);
    assert_eq!(ran.code, Some(5), "{}", ran.err);
    let message = "error: cannot write a.exr: File too large";
    assert!(ran.err.starts_with(message), "{}", ran.err);
    assert_eq!(names(folder.path()), ["a.exr", "scene.scn"]);
    let old = fs::read(folder.path().join("a.exr")).expect("a file");
    assert_eq!(old, b"old");
    // With room it is replaced.
    assert_eq!(
        words(folder.path(), &format!("{RENDER} -o a.exr")).code,
        Some(0)
    );
    assert!(fs::read(folder.path().join("a.exr")).expect("a file") != b"old");
}
