//! Lines as other programs of the course and other machines have them: read where they cannot be mistaken, with a
//! warning, and refused otherwise.

use std::fs;
use std::path::Path;

use glam::{DQuat, DVec3};
use vkpt::scene::{Camera, Geometry, MaterialKind, parse};

use super::read_lines;

/// The reading of a camera line, and the warnings; or the errors.
fn camera(line: &str) -> Result<(Camera, Vec<String>), String> {
    let read =
        parse(&format!("screen 4 3\n{line}\n"), Path::new("a.scn"), false).map_err(|errors| {
            let printed: Vec<_> = errors.diagnostics.iter().map(ToString::to_string).collect();
            printed.join("; ")
        })?;
    let printed = read
        .warnings
        .iter()
        .map(|w| format!("{}: {}", w, w.label))
        .collect();
    Ok((read.scene.camera, printed))
}

/// A rotation by 90 degrees about y, as all spellings have it.
const TURN: &str = "0.7071068 0 0.7071068 0";

#[test]
fn cameras_of_other_programs() {
    const OTHER: &str = "the arguments of `camera` are in the order of another program: ";
    let rows = [
        // The course's own.
        (format!("camera 1 2 3  .4  q {TURN}"), vec![]),
        ("camera 1 2 3  .4  y 90".into(), vec![]),
        // Aperture and focus before or after the orientation.
        (
            "camera 1 2 3  .4  0 0  y 90".into(),
            vec!["`0` is not a rotation: ignored".to_owned()],
        ),
        (
            format!("camera 1 2 3  .4  0.02 5  q {TURN}"),
            vec!["`0.02` is not a rotation: ignored".into()],
        ),
        (
            format!("camera 1 2 3  .4  q {TURN}  0.02 5"),
            vec!["`0.02` is not a rotation: ignored".into()],
        ),
        (
            format!("camera 1 2 3  .4  q {TURN}  5"),
            vec!["`5` is not a rotation: ignored".into()],
        ),
        // Words within the orientation, each alone.
        (
            "camera 1 2 3  .4  x 0 up y 90".into(),
            vec!["`up` is not a rotation: ignored".into()],
        ),
        (
            "camera 1 2 3  .4  pinhole y 45 and y 45 # look".into(),
            ["pinhole", "and", "#"]
                .map(|word| format!("`{word}` is not a rotation: ignored"))
                .to_vec(),
        ),
        // The quaternion first.
        (
            format!("camera 1 2 3  q {TURN}  .4"),
            vec![format!("{OTHER}read as the orientation, then ry")],
        ),
        (
            "camera 1 2 3  x 0 y 90  .4".into(),
            vec![format!("{OTHER}read as the orientation, then ry")],
        ),
        (
            format!("camera 1 2 3  {TURN}  .4"),
            vec![format!("{OTHER}read as the orientation, then ry")],
        ),
        // Without its q.
        (
            format!("camera 1 2 3  .4  {TURN}"),
            vec![format!(
                "{OTHER}read as ry, then the orientation as a quaternion w x y z"
            )],
        ),
        (
            format!("camera 1 2 3  .4  0.1 7  {TURN}"),
            vec![format!(
                "{OTHER}read as ry, then the orientation as a quaternion w x y z"
            )],
        ),
        (
            format!("camera 1 2 3  {TURN}  .4  0.1 7"),
            vec![
                format!("{OTHER}read as the orientation, then ry"),
                "`0.1` is not a rotation: ignored".into(),
            ],
        ),
    ];
    for (line, warnings) in rows {
        let (camera, printed) = camera(&line).expect(&line);
        assert_eq!(
            (camera.eye, camera.ry),
            (DVec3::new(1.0, 2.0, 3.0), 0.4),
            "{line}"
        );
        let y90 = DQuat::from_rotation_y(90_f64.to_radians());
        assert!(
            camera.orientation.abs_diff_eq(y90, 1e-7),
            "{line}: {:?}",
            camera.orientation
        );
        assert_eq!(printed.len(), warnings.len(), "{line}: {printed:?}");
        for warning in warnings {
            assert!(printed.contains(&warning), "{line}: {printed:?}");
        }
    }
}

/// Which number is which cannot be known: a wrong view would be rendered for an hour.
#[test]
fn cameras_that_could_be_mistaken_are_refused() {
    let rows = [
        // Angles of which axes, in which order?
        "camera 1 2 3  .4  10 20 30",
        "camera 1 2 3  .4  10 20 30  0.1 5",
        // Both 1..4 and 2..5 have norm 1.
        "camera 1 2 3  0 1 0 0 0",
        "camera 1 2 3  .5 .5 .5 .5 .5",
        // Neither has.
        "camera 1 2 3  .4 1 2 3 4",
        "camera 1 2 3  .4 0 0 0 1 2 3 4 5",
        "camera 1 2 3  .4 1 2 3 y 90",
    ];
    for line in rows {
        let error = camera(line).expect_err(line);
        assert_eq!(
            error, "the arguments of `camera` are in the order of another program",
            "{line}"
        );
    }
    let error = camera("camera 1 2 3  q 1 0 0 0").expect_err("no ry");
    assert_eq!(error, "`camera` has too few arguments");
    // No more than the aperture and the focus: the orientation is none.
    let (plain, printed) = camera("camera 1 2 3  .4  0.1 5").expect("a view");
    assert_eq!((plain.orientation, printed.len()), (DQuat::IDENTITY, 1));
}

#[test]
fn without_transmission_the_ior_is_not_read() {
    for ior in ["0", "-1", "1.5", "0.0"] {
        let read = read_lines(&format!(
            "brdf .5 .5 .5 .1 .1 .1 10 0 0 0 {ior}\nsphere 0 0 0 1"
        ))
        .expect(ior);
        assert!(read.warnings.is_empty(), "{:?}", read.warnings);
        let MaterialKind::Brdf(brdf) = &read.scene.materials[0].kind else {
            panic!("a light")
        };
        assert_eq!((brdf.kt, brdf.ior), (DVec3::ZERO, 1.0));
        let glass = read_lines(&format!("brdf .5 .5 .5 .1 .1 .1 10 0 .1 0 {ior}"));
        assert_eq!(glass.is_ok(), ior == "1.5", "{ior}");
    }
    let error = read_lines("brdf .5 .5 .5 .1 .1 .1 10 0 0 0 glass").expect_err("no number");
    assert_eq!(error.diagnostics[0].to_string(), "`glass` is not a number");
}

#[test]
fn commands_of_other_programs_name_the_effect_of_their_absence() {
    let rows = [
        (
            "skydome sky.hdr 2",
            "the picture lacks these surroundings and their light",
        ),
        (
            "passes 512",
            "the number of samples is not part of the scene",
        ),
        ("lighttex a.png", "the picture lacks this texture"),
        ("torus 0 0 0 1 .2", "the picture lacks this shape"),
        ("SDF 1", "the picture lacks this shape"),
        ("aperture .1", "without a `lens` the whole picture is sharp"),
        ("fog .1", "the picture lacks this medium"),
        ("pointlight 0 0 9 1 1 1", "the picture lacks this light"),
    ];
    for (line, lacking) in rows {
        let read = read_lines(&format!("{line}\nsphere 0 0 0 1")).expect(line);
        let printed: Vec<_> = read.warnings.iter().map(ToString::to_string).collect();
        let word = line.split(' ').next().unwrap_or_default();
        assert_eq!(printed, [format!("`{word}` is not supported: {lacking}")]);
        assert_eq!(read.scene.shapes.len(), 1);
    }
}

#[test]
fn lines_of_a_scene_end_as_they_may() {
    let text = "screen 4 3\ncamera 0 0 5 0.5\n# caf\u{e9}\nlight 1 1 1\nsphere 0 0 0 1\n";
    for ending in ["\n", "\r\n", "\r", "\r\r\n"] {
        for mark in ["", "\u{feff}"] {
            let text = format!("{mark}{}", text.replace('\n', ending));
            let read = parse(&text, Path::new("a.scn"), true)
                .expect("a scene")
                .scene;
            assert_eq!(read.shapes.len(), 1, "{text:?}");
        }
    }
    let mixed = "screen 4 3\r\ncamera 0 0 5 0.5\rlight 1 1 1\nsphere 0 0 0 1\rsphere 0 0 0 2\r\n";
    assert_eq!(
        parse(mixed, Path::new("a.scn"), true)
            .expect("a scene")
            .scene
            .shapes
            .len(),
        2
    );
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// The file that a `mesh` line reads in a folder of meshes, and the messages; or the error and its help.
fn mesh_read(name: &str) -> Result<(String, Vec<String>), String> {
    let folder = tempfile::tempdir().expect("a folder");
    let root = folder.path();
    fs::create_dir(root.join("models")).expect("a folder");
    for file in ["models/Bunny.obj", "my table.obj", "two.obj", "TWO.obj"] {
        fs::write(root.join(file), TRIANGLE).expect("a file");
    }
    let scene = format!("screen 4 3\ncamera 0 0 5 0.5\nmesh {name} 0 0 0 1 x 90\n");
    let shown = |text: String| text.replace(&*root.to_string_lossy(), "");
    let read = parse(&scene, &root.join("a.scn"), false).map_err(|errors| {
        let first = &errors.diagnostics[0];
        shown(format!(
            "{first} ({})",
            first.help.clone().unwrap_or_default()
        ))
    })?;
    let Geometry::Mesh(mesh) = &read.scene.shapes[0].geometry else {
        panic!("no mesh")
    };
    let printed = read.warnings.iter().map(|w| shown(w.to_string())).collect();
    Ok((shown(mesh.path.display().to_string()), printed))
}

#[test]
fn meshes_under_names_of_other_machines() {
    let rows = [
        ("models/Bunny.obj", "/models/Bunny.obj", false),
        ("models\\Bunny.obj", "/models/Bunny.obj", true),
        (".\\models\\bunny.OBJ", "/./models/Bunny.obj", true),
        ("MODELS/bunny.obj", "/models/Bunny.obj", true),
        ("\"models/Bunny.obj\"", "/models/Bunny.obj", true),
        ("'models\\bunny.obj'", "/models/Bunny.obj", true),
        ("\"my table.obj\"", "/my table.obj", true),
        ("my table.obj", "/my table.obj", true),
        ("two.obj", "/two.obj", false),
    ];
    for (name, path, warned) in rows {
        let (read, printed) = mesh_read(name).expect(name);
        assert_eq!(read, path, "{name}");
        let expected = format!("`{name}` is read as {path}");
        assert_eq!(
            printed,
            if warned { vec![expected] } else { vec![] },
            "{name}"
        );
    }
}

#[test]
fn meshes_that_are_missing_are_named() {
    let rows = [
        (
            "models/Buny.obj",
            "/models/Buny.obj: no such file (did you mean `Bunny.obj`?)",
        ),
        (
            "C:\\meshes\\two.obj",
            "/C:\\meshes\\two.obj: no such file (did you mean `two.obj`?)",
        ),
        // Both `two.obj` and `TWO.obj` exist.
        (
            "Two.obj",
            "/Two.obj: no such file (did you mean `two.obj`?)",
        ),
        (
            "\"lost chair.obj\"",
            "/lost chair.obj: no such file (a mesh is searched next to the scene file, then in the working directory)",
        ),
    ];
    for (name, message) in rows {
        assert_eq!(mesh_read(name).expect_err(name), message, "{name}");
    }
}
