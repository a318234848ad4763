//! Beyond f32: scenes that give a warning when loaded, because no picture of them is right.

use crate::check::case::{Case, Expectation, Stiffness};

pub fn cases() -> Vec<Case> {
    vec![
        case(
            "too-small",
            "a ball 1e-3 wide, 1e6 from the middle of the scene",
            "camera 1e6 0 4 .3",
            "brdf .5 .5 .5 0 0 0 1\nsphere 1e6 0 0 5e-4\nsphere -1e6 0 0 1e5",
            "where single precision resolves places to",
        ),
        case(
            "vanishing",
            "a ball of 1e-25 in a scene 1 wide",
            "camera 0 0 4 .3",
            "brdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 1e-25",
            "where single precision resolves places to",
        ),
        case(
            "too-narrow",
            "pixels 1e-9 as wide as their distance",
            "camera 0 0 4 1e-8",
            "brdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 1",
            "many see the same point",
        ),
    ]
}

fn case(name: &str, about: &str, camera: &str, shapes: &str, words: &str) -> Case {
    let text = format!("screen 16 16\n{camera}\nbackground 1 1 1\n{shapes}\n");
    // No digit needs to be right, but every sample must be a number.
    let lost = f64::from(1 << 24);
    let stiff = Stiffness::new(4.0, lost, lost, "none of the 24 bits remain");
    Case::new(format!("beyond/{name}"), about, text, stiff)
        .expect(Expectation::Warning(words.into()))
}
