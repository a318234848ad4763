//! Features as sets of members.

use std::collections::HashSet;

use vkpt::features::{Features, Member};
use vkpt::film::Aov;
use vkpt::prepared::{LightKind, ShapeKind};
use vkpt::settings::Settings;

use super::scenes::small_scenes;
use crate::common::render::prepared_file;
use crate::common::scenes::scene_files;
use crate::common::settings::{estimators, models};

#[test]
fn the_full_kernel_has_the_parts_of_every_scene() {
    let settings = Settings::default();
    let full = Features::full(&settings, &[]);
    assert_eq!(full.members(), Member::all(&settings));
    assert_eq!(full.in_bvh, full.shapes);
    let files = scene_files().into_iter();
    let files = files.map(|path| prepared_file(&path, &settings, None));
    for scene in files.chain(small_scenes(&settings).into_iter().map(|s| s.1)) {
        let needed = Features::of(&scene, &settings, &[]);
        assert!(needed.members().is_subset(&full.members()), "{needed}");
        let grown = needed.members().into_iter().chain(full.members());
        assert_eq!(grown.fold(needed, |f, member| f.with(member)), full);
    }
}

#[test]
fn a_member_is_there_once_it_is_put_in_and_gone_once_it_is_taken_out() {
    let full = Features::full(&Settings::default(), &[]);
    for member in full.members() {
        let without = full.without(member);
        assert!(!without.members().contains(&member), "{member:?}");
        assert!(
            without.with(member).members().contains(&member),
            "{member:?}"
        );
        assert_eq!(full.with(member), full);
        assert_eq!(without.without(member), without);
    }
}

#[test]
fn members_come_and_go_with_those_that_they_need() {
    let full = Features::full(&Settings::default(), &[]);
    let (mesh, light) = (
        Member::Shape(ShapeKind::Mesh),
        Member::Light(LightKind::Mesh),
    );
    let solids = full.without(mesh);
    assert!(!solids.shading_normals && !solids.in_bvh.contains(&ShapeKind::Mesh));
    assert!(!solids.members().contains(&light));
    for member in [
        light,
        Member::ShadingNormals,
        Member::InBvh(ShapeKind::Mesh),
    ] {
        assert!(solids.with(member).members().contains(&mesh), "{member:?}");
    }
}

/// Members, settings and AOVs: everything that makes another kernel makes another name.
#[test]
fn features_that_differ_have_different_names() {
    let settings = Settings::default();
    let full = Features::full(&settings, &[]);
    let mut all: HashSet<Features> = full
        .members()
        .into_iter()
        .map(|m| full.without(m))
        .collect();
    let settings = estimators().into_iter().chain(models()).map(|s| s.1);
    all.extend(settings.map(|settings| Features::full(&settings, &[])));
    all.extend([Features::full(&Settings::default(), &[Aov::Stderr]), full]);
    let names: HashSet<String> = all.iter().map(ToString::to_string).collect();
    assert_eq!(names.len(), all.len());
}
