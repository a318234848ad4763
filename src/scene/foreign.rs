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
        "use `background FILE` for a picture of surroundings, or `background r g b` for constant light",
    ),
    (
        &["passes", "pass", "samples", "spp", "iterations"],
        "the number of samples is not part of the scene",
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
        "the length of paths is not part of the scene",
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
        "use a mesh instead",
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
        "without a `lens` the whole picture is sharp",
        "use `lens RADIUS FOCUS`, which blurs what is nearer or farther than FOCUS",
    ),
    (
        &["fog", "medium", "media", "volume", "smoke", "participating"],
        "the picture lacks this medium",
        "only the inside of solids absorbs light, by their Kt",
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
        "use a small `sphere` after `light r g b` instead of a point light",
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
