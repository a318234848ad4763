//! Commands of other programs of the course, by their names in those programs' scene files.

/// The effect of a skipped command on the picture.
pub(super) struct Lacking {
    pub(super) what: &'static str,
    pub(super) help: Option<String>,
}

/// Words, the effect of skipping them, and how to replace them.
type Row = (&'static [&'static str], &'static str, &'static str);

const ROWS: [Row; 8] = [
    (
        &[
            "skydome",
            "skybox",
            "sky",
            "hdr",
            "hdri",
            "envmap",
            "environment",
            "env",
        ],
        "the picture lacks these surroundings and their light",
        "`background FILE` has a picture all around, `background r g b` constant light",
    ),
    (
        &["passes", "pass", "samples", "spp", "iterations"],
        "the number of samples is no part of the scene",
        "use --spp on the command line",
    ),
    (
        &[
            "depth",
            "maxdepth",
            "tracedepth",
            "bounces",
            "roulette",
            "russianroulette",
        ],
        "the length of paths is no part of the scene",
        "use --max-depth or --roulette on the command line",
    ),
    (
        &[
            "texture",
            "tex",
            "lighttex",
            "textures",
            "map",
            "normalmap",
            "bumpmap",
        ],
        "the picture lacks this texture",
        "",
    ),
    (
        &[
            "sdf",
            "torus",
            "cone",
            "capsule",
            "plane",
            "triangle",
            "quad",
            "disk",
            "disc",
            "ellipsoid",
            "pyramid",
            "prism",
            "octahedron",
            "hexprism",
            "roundbox",
            "roundedbox",
            "link",
            "fractal",
            "mandelbulb",
            "menger",
            "julia",
            "blend",
            "union",
            "intersection",
            "difference",
            "subtract",
            "metaball",
            "metaballs",
            "csg",
            "raymarch",
            "heightfield",
        ],
        "the picture lacks this shape",
        "a mesh can stand for it",
    ),
    (
        &[
            "aperture",
            "focus",
            "focal",
            "dof",
            "focaldistance",
            "fstop",
        ],
        "without a `lens` all of the picture is sharp",
        "`lens RADIUS FOCUS` blurs what is nearer or farther than FOCUS",
    ),
    (
        &["fog", "medium", "media", "volume", "smoke", "participating"],
        "the picture lacks this medium",
        "only the inside of a solid absorbs light, by its Kt",
    ),
    (
        &[
            "pointlight",
            "spotlight",
            "directional",
            "directionallight",
            "sun",
            "spot",
            "point",
        ],
        "the picture lacks this light",
        "a small `sphere` after `light r g b` shines like a point",
    ),
];

/// The effect of skipping the command `word`, if another program has that command.
pub(super) fn lacking(word: &str) -> Option<Lacking> {
    let word = word.to_ascii_lowercase();
    let row = ROWS.iter().find(|(words, ..)| words.contains(&&*word));
    row.map(|(_, what, help)| Lacking {
        what,
        help: (!help.is_empty()).then(|| (*help).to_owned()),
    })
}
