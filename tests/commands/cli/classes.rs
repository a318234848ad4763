//! `--aov light:PATTERN`: the light of classes of paths, as layers of the picture's EXR.

use insta::assert_snapshot;
use vkpt::image::{read, read_layer};

use super::program::{folder, shell, shown, words};

const SCENE: &str = "screen 16 12
camera 0 -5 2 .3 x 70
light 6 5 4
sphere 0 0 4 1
brdf .5 .5 .5 .2 .2 .2 .3
box -4 -4 -.1 8 8 .1
brdf 0 0 0 .04 .04 .04 0 .9 .9 .9 1.5
sphere 0 0 1 .8
";

const RENDER: &str = "scene.scn --spp 8 --quiet --checkpoint off --device cpu-f32";

/// The picture is the same as without them; each class has a layer, once, under its requested name.
#[test]
fn a_picture_has_its_classes_in_its_own_file() {
    let folder = folder(SCENE);
    let at = |name: &str| folder.path().join(name);
    for integrator in ["path", "light", "bidirectional"] {
        let line = format!("{RENDER} --integrator {integrator}");
        let plain = words(folder.path(), &format!("{line} -o plain.exr"));
        assert_eq!(plain.code, Some(0), "{}", plain.err);
        let asked = "--aov light:EL,light:ED.*L,depth --aov light:E[GS].*L --aov light:EL";
        let split = words(folder.path(), &format!("{line} {asked} -o split.exr"));
        assert_eq!(split.code, Some(0), "{}", split.err);
        let [plain, split] = ["plain.exr", "split.exr"].map(|name| read(&at(name)).expect(name));
        assert_eq!(plain.film, split.film);
        for note in [
            "layers: means over the first 4 samples\n",
            "light: of classes of paths, means over all 8 samples\n",
        ] {
            assert!(split.notes.contains(note), "{}", split.notes);
            assert!(!plain.notes.contains(note));
        }
        let layer = |name| read_layer(&at("split.exr"), name).expect(name).film;
        let layers = ["light:EL", "light:ED_*L", "light:E[GS]_*L"].map(layer);
        for (i, whole) in split.film.rgb.iter().enumerate() {
            for (c, &whole) in whole.iter().enumerate() {
                let sum: f32 = layers.iter().map(|layer| layer.rgb[i][c]).sum();
                assert!((sum - whole).abs() <= 1e-5 * whole, "{sum} and {whole}");
            }
        }
    }
}

/// Names of more than 31 bytes need a flag in the file.
#[test]
fn a_class_may_have_a_long_name() {
    let folder = folder(SCENE);
    let pattern = format!("light:E({}D)S*L", "D|G|S|".repeat(25));
    let line = format!("{RENDER} --aov {pattern} -o a.exr");
    assert_eq!(words(folder.path(), &line).code, Some(0), "{line}");
    let file = folder.path().join("a.exr");
    assert!(read_layer(&file, &pattern).is_ok());
    // OpenEXR File Layout, "Version Field": bit 10.
    let bytes = std::fs::read(&file).expect("a file");
    assert_eq!(bytes[5] & 4, 4);
}

/// `compare` takes the pattern as `--aov` does, and the layer's own name.
#[test]
fn classes_are_compared_by_their_patterns() {
    let folder = folder(SCENE);
    for (name, more) in [("a", ""), ("b", " --seed 1")] {
        let line = format!("{RENDER}{more} --aov light:EL,light:ED.L -o {name}.exr");
        assert_eq!(words(folder.path(), &line).code, Some(0), "{line}");
    }
    let compare = |a: &str, b: &str, layer: &str| {
        let line = format!("compare {a}.exr {b}.exr --max-relmse 1e-12 --layer {layer}");
        words(folder.path(), &line)
    };
    for name in ["light:ED.L", "light:ED_L"] {
        assert_eq!(compare("a", "a", name).code, Some(0), "{name}");
        assert_eq!(compare("a", "b", name).code, Some(1), "{name}");
    }
    let missing = compare("a", "b", "light:EDL");
    assert_eq!(missing.code, Some(3));
    assert_snapshot!(missing.err);
}

#[test]
fn invalid_classes_are_refused() {
    let folder = folder(SCENE);
    let part = words(
        folder.path(),
        "scene.scn --device cpu-f32 --spp 2 --quiet -o a.vkpt",
    );
    assert_eq!(part.code, Some(0), "{}", part.err);
    let lines = [
        "scene.scn --aov light:ED+ -o a.exr",
        "scene.scn --aov light -o a.exr",
        "explain scene.scn --aov light:ED{2}L",
        "scene.scn --aov light:E.*L -o a.png",
        "merge a.vkpt --aov light:EL -o a.exr",
    ];
    let messages = lines.map(|line| {
        let run = words(folder.path(), line);
        assert_eq!(run.code, Some(2), "{line}: {}", run.err);
        assert!(!folder.path().join("a.exr").exists() && !folder.path().join("a.png").exists());
        shown(&line.split(' ').collect::<Vec<_>>(), &run.err)
    });
    assert_snapshot!(messages.concat());
}

/// The picture is written all the same, with the settings that it was made from; the missing layer is reported.
#[cfg(unix)]
#[test]
fn an_interruption_leaves_the_picture_without_classes() {
    let folder = folder(SCENE);
    let picture = folder.path().join("a.exr");
    // One that was met before its first sample leaves nothing, and the next is given more time.
    for seconds in [1, 2, 4, 8, 16] {
        let run = shell(
            folder.path(),
            &format!(
                "timeout --preserve-status -s INT {seconds} $VKPT scene.scn --device cpu-f32 --spp 4000000 --quiet --aov light:EL -o a.exr"
            ),
        );
        if picture.exists() {
            assert_eq!(run.code, Some(130), "{}", run.err);
            let message =
                "warning: interrupted: the picture is written without the layers of --aov light\n";
            assert!(run.err.contains(message), "{}", run.err);
            assert!(read_layer(&picture, "light:EL").is_err());
            assert!(folder.path().join("a.vkpt").exists());
            return;
        }
    }
    panic!("no rendering began within seconds");
}
