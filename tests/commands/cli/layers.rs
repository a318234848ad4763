//! `--aov albedo,…`: layers of the picture's EXR, and `compare --layer`.

use std::fs;

use vkpt::image::{read, read_layer};

use super::program::{folder, words};

const SCENE: &str = "screen 16 12
camera 0 0 5 .4
background .5 .5 .5
brdf .5 .25 .125 0 0 0 1
sphere 0 0 0 1
brdf 0 0 0 .9 .9 .9 0
box -3 -2 -2 6 .5 4
";

const RENDER: &str = "scene.scn --spp 8 --quiet --checkpoint off";

/// Every layer on every device, and the picture as it is without.
#[test]
fn a_picture_has_its_layers_in_its_own_file() {
    let folder = folder(SCENE);
    let at = |name: &str| folder.path().join(name);
    for device in ["cpu-f32", "cpu-f64"] {
        let plain = format!("{RENDER} --device {device} -o plain.exr");
        let layered = format!(
            "{RENDER} --device {device} --aov albedo,normal,depth,position,shape,material,samples,albedo*,normal* -o {device}.exr -o {device}.png"
        );
        for line in [plain, layered] {
            let run = words(folder.path(), &line);
            assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{line}");
        }
        let picture = |name: &str| read(&at(name)).expect("a picture");
        let layered = picture(&format!("{device}.exr"));
        assert_eq!(picture("plain.exr").film, layered.film);
        assert!(
            layered
                .notes
                .contains("layers: means over the first 4 samples\n")
        );
        assert!(!picture("plain.exr").notes.contains("layers"));
    }
    let layer = |name: &str, layer: &str| read_layer(&at(name), layer).expect(layer).film;
    let middle = 6 * 16 + 8;
    assert_eq!(layer("cpu-f32.exr", "Samples.N").rgb[middle], [8.0; 3]);
    assert_eq!(layer("cpu-f32.exr", "Shape.Line").rgb[middle], [5.0; 3]);
    assert_eq!(
        layer("cpu-f32.exr", "Albedo").rgb[middle],
        [0.5, 0.25, 0.125]
    );
    for name in [
        "Albedo",
        "AlbedoBehind",
        "N",
        "Ns",
        "NsBehind",
        "P",
        "Z",
        "Material.Line",
    ] {
        assert_eq!(
            layer("cpu-f32.exr", name),
            layer("cpu-f64.exr", name),
            "{name}"
        );
    }
}

#[test]
fn layers_are_compared_by_name() {
    let folder = folder(SCENE);
    fs::write(
        folder.path().join("other.scn"),
        SCENE.replace(".125", ".25"),
    )
    .expect("a scene");
    for (scene, name) in [("scene", "a"), ("other", "b")] {
        let line = RENDER.replace("scene.scn", &format!("{scene}.scn"));
        let line = format!("{line} --device cpu-f32 --aov albedo,depth -o {name}.exr");
        assert_eq!(words(folder.path(), &line).code, Some(0), "{line}");
    }
    let compare = |layer: &str| {
        let line = format!("compare a.exr b.exr --max-relmse 1e-9 --layer {layer}");
        words(folder.path(), &line)
    };
    assert_eq!(compare("Z").code, Some(0));
    // Blue alone differs.
    let albedo = compare("Albedo");
    assert_eq!(albedo.code, Some(1));
    assert!(albedo.out.contains("mean B"), "{}", albedo.out);
    let missing = compare("Normal");
    assert_eq!(missing.code, Some(3));
    let message =
        "a.exr: has no layer Normal; its channels are Albedo.B, Albedo.G, Albedo.R, B, G, R, Z";
    assert!(missing.err.contains(message), "{}", missing.err);
}

#[test]
fn layers_that_have_no_place_are_refused() {
    let folder = folder(SCENE);
    for (line, message) in [
        (
            "scene.scn --aov albedo -o a.png",
            "error: --aov albedo is a layer of an EXR, but no EXR is written: add -o NAME.exr",
        ),
        (
            "merge a.vkpt --aov depth -o a.exr",
            "error: --aov depth needs the scene, which parts do not contain: render it with vkpt SCENE",
        ),
        (
            "scene.scn --aov colour -o a.exr",
            "error: invalid value 'colour'",
        ),
    ] {
        if line.starts_with("merge") {
            let part = words(
                folder.path(),
                "scene.scn --device cpu-f32 --spp 2 --quiet -o a.vkpt",
            );
            assert_eq!(part.code, Some(0), "{}", part.err);
        }
        let run = words(folder.path(), line);
        assert_eq!(run.code, Some(2), "{line}: {}", run.err);
        assert!(run.err.starts_with(message), "{line}: {}", run.err);
        assert!(!folder.path().join("a.exr").exists() && !folder.path().join("a.png").exists());
    }
}
