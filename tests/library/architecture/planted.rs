//! Violations of the table, planted in made-up sources.

use super::source::Source;
use super::table::rows;
use super::{idle, violations};

const TABLE: &str = "\
| `src/scene/` | text | nothing |
| `src/film.rs` | a picture | nothing |
| `src/gpu/` | devices | `film` |
| `src/kernel/` | kernels | `film` |
| `src/render/` | rendering | `gpu::Device`, `scene`, `render::tiles` |
| `src/render/tiles/` | a room in a room | `scene` |
| `lab/src/cli/` | commands | everything |
| `lab/src/check/` | a tool | `scene`, `lab::cli` |
";

#[test]
fn a_planted_violation_is_found() {
    let table = rows(TABLE).expect("a table");
    let found = |path: &str, text: &str| violations(&Source::new(path, text), &table);
    let ok = [
        (
            "gpu/device.rs",
            "// SAFETY: it is.\nunsafe { ash::x(crate::film::Film) }",
        ),
        ("kernel/compile.rs", "use naga::Module;"),
        (
            "lab/cli/render.rs",
            "println!(\"done\"); use vkpt::{gpu, scene};",
        ),
        (
            "scene/mod.rs",
            "// unsafe to naga:: and crate::gpu\n//! crate::gpu",
        ),
        (
            "scene/text.rs",
            "use super::lines; use crate::scene::text; crate::some_macro!();",
        ),
        (
            "render/mod.rs",
            "use crate::gpu::Device; use crate::gpu::Device::open; use crate::render::tiles;",
        ),
        ("render/tiles/mod.rs", "use crate::scene::Scene;"),
        ("lib.rs", "pub mod scene;"),
        ("lab/lib.rs", "pub mod check;"),
        (
            "lab/check/mod.rs",
            "use vkpt::scene::Scene; use crate::cli; use crate::check::x;",
        ),
    ];
    for (path, text) in ok {
        assert_eq!(found(path, text), Vec::<String>::new());
    }
    let bad = [
        ("scene/mod.rs", "use crate::film::Film;"),
        ("scene/mod.rs", "use super::film::Film;"),
        ("scene/mesh/ply.rs", "use super::super::super::film;"),
        (
            "gpu/mod.rs",
            "use crate::{\n    film::Film,\n    scene,\n};",
        ),
        ("gpu/mod.rs", "let x = crate::kernel::compile();"),
        ("render/mod.rs", "use crate::gpu::Buffer;"),
        ("render/mod.rs", "use crate::gpu;"),
        ("render/tiles/mod.rs", "use super::Job;"),
        ("film.rs", "fn f() { unsafe { g() } }"),
        ("render/mod.rs", "use naga::Module;"),
        ("kernel/mod.rs", "use ash::vk;"),
        ("kernel/mod.rs", "use unaudited::compile;"),
        ("render/cpu.rs", "    eprintln!(\"slow\");"),
        ("lab/check/mod.rs", "use vkpt::film::Film;"),
        ("lab/check/mod.rs", "use vkpt::{film, scene};"),
        ("lab/check/mod.rs", "println!();"),
        ("scene/mod.rs", "use vkpt_lab::check;"),
        ("shelf/mod.rs", "use std::fs;"),
        ("shelf.rs", ""),
    ];
    for (path, text) in bad {
        assert_eq!(found(path, text).len(), 1, "{path}: {text}");
    }
}

#[test]
fn a_table_that_says_too_much_is_found() {
    let table = rows(TABLE).expect("a table");
    let sources = [
        ("scene/mod.rs", ""),
        ("film.rs", ""),
        ("kernel/mod.rs", "use crate::film::Film;"),
        (
            "render/mod.rs",
            "use crate::gpu::Device; use crate::scene; mod tiles; use self::tiles::Tile;",
        ),
        ("render/tiles/mod.rs", ""),
        ("lab/cli/mod.rs", ""),
        ("lab/check/mod.rs", "use vkpt::scene; use crate::cli;"),
    ];
    let sources = sources.map(|(path, text)| Source::new(path, text));
    let expected = [
        "there is no room gpu",
        "gpu does not use film",
        "render::tiles does not use scene",
    ];
    assert_eq!(idle(&table, &sources), expected);
}
