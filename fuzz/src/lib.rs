//! Properties that must hold for any bytes of a file: a function a reader, which panics on a violation.
//!
//! `fuzz_targets/` calls them with bytes that libFuzzer invents, vkpt's own tests with the stored inputs and with some
//! that they invent.

mod mesh;
mod model;
mod part;
mod picture;
mod prepared;
mod scene;

pub use mesh::{gltf, obj, ply};
pub use model::model;
pub use part::part;
pub use picture::picture;
pub use scene::scene;

/// An error has a message, without characters that control a terminal.
fn has_message(error: &dyn std::fmt::Display) {
    let message = error.to_string();
    assert!(!message.is_empty(), "an error without a message");
    assert!(!message.chars().any(char::is_control), "{message:?}");
}
