//! Twins by name: every GLSL function has a Rust function of the same file, name and argument names, in their order.
//!
//! `tests/device/twins/` compares their results. Here the texts are read: the files of `shaders/`, the dispatch that is
//! generated for a scene, and `src/reference/`. A Rust function takes as arguments the things that a kernel has in its buffers
//! and slots (a world, settings, slices): such arguments do not count. Every other difference is in a list below, with its
//! reason; a reason that no function needs any more fails.

mod exceptions;
mod functions;

use std::collections::BTreeSet;
use std::path::PathBuf;

use exceptions::{ARGUMENTS, HOMES, KERNEL_ONLY, REFERENCE_ONLY};
use functions::{Function, glsl_functions, rust_functions, sources, undocumented};
use vkpt::features::Features;
use vkpt::kernel::scene::{Parameters, Recording, compose};
use vkpt::kernel::{file, files};
use vkpt::prepared::LightKind;
use vkpt::settings::{Integrator, Settings};

use crate::common::{self, root};

/// All functions of `shaders/`, and those that are generated for a scene of every kind of shape, light and material.
fn kernel_functions() -> Vec<Function> {
    let library = files().filter(|f| !f.ends_with(".comp"));
    let written = library.flat_map(|f| glsl_functions(f, file(f).unwrap_or_default()));
    let mut all: Vec<Function> = written.collect();
    let known: BTreeSet<String> = all.iter().map(|f| f.name.clone()).collect();
    let generated = glsl_functions("generated", &generated());
    let roots: Vec<&str> = files().filter(|f| f.ends_with(".comp")).collect();
    let of_root = |f: &Function| {
        let mut texts = roots.iter().filter_map(|root| file(root));
        texts.any(|text| text.contains(&format!(" {}(", f.name)))
    };
    let mut seen = BTreeSet::new();
    for f in generated {
        if !known.contains(&f.name) && !of_root(&f) && seen.insert(f.name.clone()) {
            all.push(f);
        }
    }
    all
}

/// The kernels of a scene that needs everything, of paths from the eye and from both ends.
fn generated() -> String {
    let cube = common::meshes::cube();
    let sky = common::surroundings::uneven_sky();
    let text = format!(
        "{}light 1 1 1\nbox 2 2 2 1 1 1\nmesh {} 3 3 3 .1\n{}",
        common::scenes::WIDE,
        cube.path().display(),
        common::surroundings::background(&sky, "")
    );
    let kernels = |integrator| {
        let mut settings = Settings::default();
        settings.estimator.integrator = integrator;
        let features = Features::of(&common::render::prepared(&text, &settings), &settings, &[]);
        let parameters = Parameters {
            settings: &settings,
            bindings: &[],
            bvh: None,
            background_light: Some(0),
            outside: Some(LightKind::Surroundings),
            recording: Recording::Nothing,
            read_first: true,
            own_files: &[],
        };
        let kernels = compose(&features, &parameters).expect("kernels");
        kernels.iter().map(|k| k.text().to_owned()).collect()
    };
    [Integrator::Path, Integrator::Bidirectional]
        .map(kernels)
        .map(|texts: Vec<String>| texts.concat())
        .concat()
}

/// Where the twin of a function of this GLSL file may be, the first that has one: the same path, the folder's own file, or
/// its home.
fn homes(glsl: &str) -> Vec<String> {
    let folder = glsl.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut all = vec![glsl.to_owned(), folder.to_owned()];
    all.extend(
        (HOMES.iter())
            .filter(|h| glsl.starts_with(h.0))
            .map(|h| h.1.to_owned()),
    );
    all
}

/// The errors of a kernel's function, given the reference's; marks the exceptions that it needs.
fn complaint<'a>(
    glsl: &'a Function,
    rust: &[Function],
    used: &mut BTreeSet<&'a str>,
) -> Option<String> {
    let named = |list: &[(&str, &str)], key: &str| list.iter().any(|(name, _)| *name == key);
    let homes = homes(&glsl.file);
    let in_home = |home: &String| rust.iter().find(|r| r.name == glsl.name && r.file == *home);
    let twin = homes.iter().find_map(in_home);
    let Some(twin) = twin else {
        let key = KERNEL_ONLY
            .iter()
            .find(|(start, _)| glsl.file.starts_with(start) || glsl.name == *start);
        used.extend(key.map(|(start, _)| *start));
        return key
            .is_none()
            .then(|| format!("{glsl}: no such function in {homes:?}"));
    };
    if twin.arguments == glsl.arguments {
        return None;
    }
    if named(ARGUMENTS, &glsl.name) {
        used.insert(&glsl.name);
        return None;
    }
    Some(format!("{glsl}, but {twin}"))
}

fn complaints(kernel: &[Function], rust: &[Function]) -> Vec<String> {
    let mut used = BTreeSet::new();
    let mut all: Vec<String> = (kernel.iter())
        .filter_map(|f| complaint(f, rust, &mut used))
        .collect();
    let idle = KERNEL_ONLY
        .iter()
        .chain(ARGUMENTS)
        .filter(|(key, _)| !used.contains(key));
    all.extend(
        idle.map(|(key, reason)| {
            format!("{key}: nothing needs this exception any more ({reason})")
        }),
    );
    all
}

#[test]
fn every_function_of_a_kernel_has_a_twin_of_its_name() {
    let bad = complaints(&kernel_functions(), &rust_functions());
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

/// And the other way round: the reference has no function that could have a twin and has none.
#[test]
fn every_function_of_the_reference_has_a_twin_or_a_reason() {
    let kernel: BTreeSet<String> = kernel_functions().into_iter().map(|f| f.name).collect();
    let free = rust_functions()
        .into_iter()
        .filter(|f| !f.method && !kernel.contains(&f.name));
    let mut used = BTreeSet::new();
    let mut bad = Vec::new();
    for f in free {
        match REFERENCE_ONLY
            .iter()
            .find(|(key, _)| f.file.starts_with(key) || f.name == *key)
        {
            Some((key, _)) => {
                used.insert(*key);
            }
            None => bad.push(format!("{f}: only in the reference")),
        }
    }
    let idle = REFERENCE_ONLY.iter().filter(|(key, _)| !used.contains(key));
    bad.extend(
        idle.map(|(key, reason)| {
            format!("{key}: nothing needs this exception any more ({reason})")
        }),
    );
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

/// The reference is written to be read.
#[test]
fn every_public_function_of_the_reference_is_explained() {
    let root = root().join("src/reference");
    let bare = |(path, text): &(PathBuf, String)| {
        let of_file = undocumented(text).into_iter();
        of_file
            .map(|f| format!("{}: {f}", path.display()))
            .collect::<Vec<_>>()
    };
    let bad: Vec<String> = sources(&root).iter().flat_map(bare).collect();
    assert!(bad.is_empty(), "without a doc comment:\n{}", bad.join("\n"));
}

/// A renamed function, another file, swapped and renamed arguments are noticed.
#[test]
fn planted_differences_are_noticed() {
    let kernel = kernel_functions();
    let rust = rust_functions();
    let before = complaints(&kernel, &rust).len();
    let plants: [fn(&mut Function); 4] = [
        |f| f.name.push('x'),
        |f| f.file.push('x'),
        |f| f.arguments.swap(0, 1),
        |f| f.arguments[0] = "k".into(),
    ];
    for plant in plants {
        let mut planted = rust_functions();
        let target = planted.iter_mut().find(|f| f.name == "fresnel_exact");
        plant(target.expect("a function of two arguments"));
        assert_eq!(complaints(&kernel, &planted).len(), before + 1);
    }
}
