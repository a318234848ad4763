//! The project's own scenes, in scenes/.

use std::path::PathBuf;

use vkpt::scene::{Edges, Geometry, Scene, edges, read, signed_volume};

/// Every scene of the folder, read; a warning fails.
fn scenes() -> Vec<(PathBuf, Scene)> {
    let entries = std::fs::read_dir("scenes").expect("the folder of scenes");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "txt"));
    paths.sort();
    let read = |path: PathBuf| match read(&path, true) {
        Ok(read) => (path, read.scene),
        Err(errors) => panic!("{errors}: {:?}", errors.diagnostics),
    };
    paths.into_iter().map(read).collect()
}

#[test]
fn there_are_eight_or_more_small_ones_that_describe_themselves() {
    let scenes = scenes();
    assert!(scenes.len() >= 8);
    for (path, scene) in scenes {
        assert!(
            scene.screen.width <= 400 && scene.screen.height <= 300,
            "{}",
            path.display()
        );
        assert!(!scene.shapes.is_empty(), "{}", path.display());
        let text = std::fs::read_to_string(&path).expect("a text");
        let comment = text
            .lines()
            .take_while(|line| line.starts_with("# "))
            .count();
        assert!((2..=6).contains(&comment), "{}", path.display());
    }
}

#[test]
fn their_meshes_are_closed_and_wound_outwards() {
    let mut seen = 0;
    for (path, scene) in scenes() {
        for shape in &scene.shapes {
            let Geometry::Mesh(mesh) = &shape.geometry else {
                continue;
            };
            assert_eq!(
                edges(mesh),
                Edges::default(),
                "{}:{}",
                path.display(),
                shape.line
            );
            assert!(
                signed_volume(mesh) > 0.0,
                "{}:{}",
                path.display(),
                shape.line
            );
            seen += 1;
        }
    }
    assert!(seen > 0);
}
