//! Diagnostics as a person sees them, without colour: `fixtures/NAME.scn` must be answered by `fixtures/NAME.txt`.
//! With `VKPT_BLESS=1` the answers are written instead; read them before they are kept.

use std::path::{Path, PathBuf};

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use vkpt::scene::read;

/// The output on a terminal of 100 columns without colour.
fn render(diagnostic: &dyn Diagnostic) -> String {
    let mut text = String::new();
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::none()).with_width(100);
    handler
        .render_report(&mut text, diagnostic)
        .expect("a rendering");
    // Blanks at the ends of lines are lost in editors.
    text.lines()
        .map(|line| format!("{}\n", line.trim_end()))
        .collect()
}

fn answer(scene: &Path) -> String {
    match read(scene, false) {
        Ok(read) => read
            .warnings
            .iter()
            .map(|warning| render(warning))
            .collect(),
        Err(errors) => render(&errors),
    }
}

#[test]
fn diagnostics_look_as_they_should() {
    let bless = std::env::var_os("VKPT_BLESS").is_some();
    let folder = Path::new("tests/data/scene");
    let entries = std::fs::read_dir(folder).expect("the fixtures");
    let mut scenes: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    scenes.retain(|path| path.extension().is_some_and(|ending| ending == "scn"));
    assert!(scenes.len() >= 3);
    for scene in scenes {
        let (answer, expected) = (answer(&scene), scene.with_extension("txt"));
        if bless {
            std::fs::write(&expected, &answer).expect("the answer");
        }
        let expected = std::fs::read_to_string(&expected)
            .unwrap_or_else(|e| panic!("{}: {e}", expected.display()));
        assert_eq!(answer, expected, "{}", scene.display());
    }
}
