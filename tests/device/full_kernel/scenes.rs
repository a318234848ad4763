//! Small scenes that between them lack every member and need nearly every one.

use vkpt::prepared::Prepared;
use vkpt::settings::Settings;

use crate::common::meshes::{cube, ply, square};
use crate::common::render::prepared;
use crate::common::scenes::{FLUSH, LENS, MANY, SMOOTH, TABLE, WIDE, flush_meshes, surroundings};
use crate::common::surroundings::uneven_sky;

/// Clear glass, smooth and rough, under a background that is the only light.
pub const CLEAR: &str = "screen 32 24
camera 0 -6 2 .35 x 75
background .7 .8 .9
brdf .5 .4 .3 0 0 0 1
box -5 -5 -.1 10 10 .1
brdf 0 0 0 .04 .04 .04 0 1 1 1 1.5
sphere -.9 0 .8 .8
brdf 0 0 0 .04 .04 .04 .3 1 1 1 1.5
box .2 -.4 .01 1.2 1.2 1.2
";

/// Diffuse surfaces and a light.
pub const DIFFUSE: &str = "screen 32 24
camera 0 -6 3 .35 x 65
light 6 5 4
sphere 0 0 4 1
brdf .6 .5 .4 0 0 0 1
sphere 0 0 -101 101
sphere 0 0 1 1
";

/// No light.
pub const DARK: &str = "screen 8 6
camera 0 -6 3 .35 x 65
brdf .6 .5 .4 0 0 0 1
sphere 0 0 1 1
";

/// Only a background.
pub const EMPTY: &str = "screen 8 6
camera 0 -6 3 .35 x 65
background 1 2 3
";

/// A pyramid of rough glass whose normals are bent outwards.
const PYRAMID: &str = "element vertex 4
property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz
element face 4\nproperty list uchar int vertex_indices\nend_header
-1 -1 0 -.7 -.6 -.3\n1 -1 0 .7 -.6 -.3\n0 1 0 0 .9 -.3\n0 0 1.6 0 0 1
3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// The scenes by name.
pub fn small_scenes(settings: &Settings) -> Vec<(&'static str, Prepared)> {
    let (cube, square, pyramid) = (cube(), square(), ply(PYRAMID));
    let sky = uneven_sky();
    let of = |mesh: &tempfile::NamedTempFile| mesh.path().display().to_string();
    let meshes = |light: &str, glass: &str| {
        format!(
            "screen 32 24\ncamera 0 -6 2 .35 x 72\nlight 7 7 6\nmesh {light} 0 0 4 .7\n\
             brdf .5 .4 .3 0 0 0 1\nbox -5 -5 -.1 10 10 .1\n\
             brdf .1 .1 .1 .04 .04 .04 .3 .8 .9 .7 1.5\nmesh {glass} 0 0 .9 .8\n"
        )
    };
    let texts = [
        ("diffuse", DIFFUSE.to_owned()),
        ("clear", CLEAR.to_owned()),
        ("smooth", SMOOTH.to_owned()),
        ("table", TABLE.to_owned()),
        ("wide", WIDE.to_owned()),
        ("flush", FLUSH.to_owned()),
        ("many", MANY.to_owned()),
        ("lens", LENS.to_owned()),
        ("flush meshes", flush_meshes(square.path(), cube.path())),
        ("surroundings", surroundings(sky.path())),
        ("flat mesh", meshes(&of(&cube), &of(&cube))),
        ("smooth mesh", meshes(&of(&cube), &of(&pyramid))),
    ];
    let scene = |(name, text): (_, String)| (name, prepared(&text, settings));
    texts.into_iter().map(scene).collect()
}
