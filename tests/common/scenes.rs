//! Scene files, and small scenes that together contain every part of the model; each fits a picture of 32 × 24.

use std::path::{Path, PathBuf};

use super::data::data;

/// The project's scenes, and two like a course's.
pub fn scene_files() -> Vec<PathBuf> {
    let (own, classroom) = (files(Path::new("scenes")), files(&data("classroom")));
    assert!(own.len() >= 8, "{own:?}");
    assert_eq!(classroom.len(), 2, "{classroom:?}");
    own.into_iter().chain(classroom).collect()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let is_scene = |p: &PathBuf| p.extension().is_some_and(|e| e == "txt" || e == "scn");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(is_scene)
        .collect();
    files.sort();
    files
}

/// GGX: absorbing rough glass, a rough opaque block with Kd, a floor; a ball of light.
pub const TABLE: &str = "screen 32 24
camera 0 -6 3 .35 x 65
light 6 5 4
sphere 0 0 4 1
brdf .6 .5 .4 0 0 0 1
box -5 -5 -.1 10 10 .1
distribution ggx
brdf 0 0 0 .04 .04 .04 .3 .9 .5 .3 1.5
sphere -1 0 .8 .8
brdf .3 .3 .4 .3 .3 .2 .4
box .4 -.5 .002 1.1 1.1 1.1
";

/// Everything smooth: glass with exact Fresnel and absorption, a mirror, a floor; a background and a box of light.
pub const SMOOTH: &str = "screen 32 24
camera 0 -6 2 .35 x 75
background .4 .5 .6
light 5 5 4
box -1 -1 4 2 2 .5
brdf .5 .5 .5 0 0 0 1
box -5 -5 -.1 10 10 .1
fresnel exact
brdf 0 0 0 .04 .04 .04 0 .8 .9 .95 1.5
sphere -.9 0 .8 .8
brdf 0 0 0 .9 .8 .7 0
cylinder .9 .2 .01 0 0 1.5 .6
";

/// Beckmann and Phong, glass and opaque, glass with Kd, a null interface; two lights to choose from.
pub const WIDE: &str = "screen 32 24
camera 0 -6 2.5 .35 x 70
light 4 4 5
cylinder -3 0 3 6 0 0 .5
light 3 2 1
sphere 3.2 1 1.5 .6
brdf .5 .5 .5 0 0 0 1
box -5 -5 -.1 10 10 .1
distribution beckmann
brdf 0 0 0 .05 .05 .05 .4 .95 .9 .6 1.4
cylinder -1.4 0 .01 0 0 1.2 .6
brdf .2 .2 .3 .4 .3 .3 .5
sphere 0 .8 .6 .6
distribution phong
brdf .2 .1 .1 .04 .04 .04 30 .9 .9 .6 1.3
sphere 1.3 -.2 .6 .6
brdf 0 0 0 0 0 0 1 .5 .7 .9 1
box -.5 -1.2 .01 .8 .6 .7
";

/// Nineteen lights, too many to look at each: balls, boxes, cylinders, one inside a glass ball, and the background.
pub const MANY: &str = "screen 32 24
camera 0 -6 2.5 .35 x 70
background .02 .03 .04
brdf .6 .55 .5 0 0 0 1
box -5 -5 -.1 10 10 .1
box -5 4 0 10 .2 4
distribution ggx
fresnel exact
brdf .1 .1 .1 .5 .45 .4 .1
box -3.6 .4 0 1 1 1.2
brdf 0 0 0 .04 .04 .04 .15 .9 .95 .9 1.5
sphere 0 .2 .71 .7
brdf 0 0 0 .04 .04 .04 0 .9 .9 .95 1.4
box 1.4 -.6 .01 .9 .9 1.1
light 23 18 22
sphere 0 0.2 0.7 .08
light 16 22 4
box -3.8 0.6 3.2 .1 .2 .05
light 15 2 7
cylinder -0.2 -0.6 2.0 .1 .1 .2 .04
light 6 20 5
sphere -1.8 3.1 2.7 0.1
light 7 7 24
box -3.0 -2.0 3.0 .1 .2 .05
light 14 17 7
cylinder 3.0 -0.4 3.3 .1 .1 .2 .04
light 22 9 10
sphere 3.5 1.9 3.3 0.05
light 15 2 17
box -2.8 -1.6 1.2 .1 .2 .05
light 13 9 13
cylinder -1.3 -0.3 2.8 .1 .1 .2 .04
light 3 18 21
sphere 1.6 -1.7 3.3 0.03
light 2 3 6
box 2.3 0.1 2.1 .1 .2 .05
light 22 23 10
cylinder 3.6 -0.9 2.6 .1 .1 .2 .04
light 4 18 20
sphere -1.2 0.9 2.7 0.13
light 9 15 22
box -3.7 3.3 0.6 .1 .2 .05
light 9 9 6
cylinder -1.3 3.2 2.0 .1 .1 .2 .04
light 24 6 3
sphere -3.4 -1.2 2.4 0.15
light 15 20 12
box 0.3 0.3 1.0 .1 .2 .05
light 3 13 20
cylinder -0.6 -1.7 3.1 .1 .1 .2 .04
";

/// Faces that coincide: a lamp flush with the ceiling, glass that stands on the floor and touches other glass, a ball and a
/// cylinder whose lines occur twice.
pub const FLUSH: &str = "screen 32 24
camera 0 -6 1.5 .35 x 80
light 6 5 4
box -1 -1 3 2 2 .1
brdf .6 .6 .6 0 0 0 1
box -5 -5 3 10 10 .2
box -5 -5 -.1 10 10 .1
sphere 1.6 0 .7 .5
cylinder 2.6 .5 .3 .2 .3 1 .3
brdf .2 .6 .6 0 0 0 1
sphere 1.6 0 .7 .5
cylinder 2.6 .5 .3 .2 .3 1 .3
fresnel exact
distribution ggx
brdf 0 0 0 .04 .04 .04 0 .9 .8 .95 1.5
box -2 -.5 0 1 1 1
brdf 0 0 0 .04 .04 .04 .2 .8 .9 .9 1.3
box -1 -.5 0 .8 1 1
cylinder .3 -.8 0 0 0 .8 .3
";

/// The same with meshes, 26 triangles and more, found in a hierarchy: a lamp whose faces occur twice, a square on the floor and
/// one turned on it, cubes of glass that touch.
pub fn flush_meshes(square: &Path, cube: &Path) -> String {
    let (square, cube) = (square.display(), cube.display());
    format!(
        "screen 32 24\ncamera 0 -6 2.5 .35 x 70\nlight 6 5 4\nmesh {square} 0 0 4 1\nmesh {square} 0 0 4 1\n\
         brdf .6 .6 .6 0 0 0 1\nbox -5 -5 -.1 10 10 .1\nbrdf .2 .6 .6 0 0 0 1\nmesh {square} 1 1 0 1.5\n\
         brdf .6 .6 .2 0 0 0 1\nmesh {square} 1 1 0 1 z 10\nbrdf 0 0 0 .04 .04 .04 .2 .8 .9 .9 1.3\n\
         mesh {cube} -1 0 .5 .5\nmesh {cube} -2 .2 .5 .5\nmesh {cube} -1 0 1.5 .5\n"
    )
}

/// Eye and floor are in a block of rough glass that absorbs, lit by a ball of light. Few rare paths contribute much of the
/// eye's view: where a few paths in a thousand contribute most of the light, Student's t is no test.
pub const INSIDE: &str = "screen 32 24
camera 0 0 0 .5 x 20
light 9 8 6
sphere .5 .5 4 .9
brdf .5 .5 .5 0 0 0 1
box -2 -2 -1.6 4 4 .2
distribution ggx
brdf 0 0 0 .04 .04 .04 .6 .9 .95 .9 1.5
box -2.5 -2.5 -2 5 5 4.5
";

/// A wide lens: the scene of `TABLE`, a null interface and a lamp, all before or behind the plane that is sharp.
pub const LENS: &str = "screen 32 24
camera 0 -6 3 .35 x 65
lens .5 4.8
light 6 5 4
sphere 0 0 4 1
light 3 2 1
sphere 1.6 2 1.4 .3
brdf .6 .5 .4 0 0 0 1
box -5 -5 -.1 10 10 .1
distribution ggx
brdf 0 0 0 .04 .04 .04 .3 .9 .5 .3 1.5
sphere -1 0 .8 .8
brdf .3 .3 .4 .3 .3 .2 .4
box .4 -.5 .002 1.1 1.1 1.1
brdf 0 0 0 0 0 0 1 .5 .7 .9 1
box -.6 -3.6 .8 1 .5 1
";

/// Diffuse, glossy and clear, under a picture that is turned, next to a light.
pub fn surroundings(picture: &Path) -> String {
    format!(
        "screen 32 24\ncamera 0 -6 2 .35 x 75\nbackground {} .7 z 40 x 15\nlight 3 2 1\nsphere 3 0 4 .5\n\
         brdf .5 .4 .3 0 0 0 1\nbox -5 -5 -.1 10 10 .1\nbrdf .2 .2 .2 .4 .3 .2 .2\nsphere -.9 0 .8 .8\n\
         brdf 0 0 0 .04 .04 .04 .3 .9 1 .8 1.5\nbox .2 -.4 .01 1.2 1.2 1.2\n",
        picture.display()
    )
}
