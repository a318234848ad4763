//! What must hold whatever a file's bytes are: a function a reader, which panics where it does not.
//!
//! `fuzz_targets/` calls them with bytes that libFuzzer invents, vkpt's own tests with those that are kept and with
//! what they invent themselves.

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

/// An error says something, and nothing that a terminal would obey.
fn is_told(error: &dyn std::fmt::Display) {
    let message = error.to_string();
    assert!(!message.is_empty(), "an error without a message");
    assert!(!message.chars().any(char::is_control), "{message:?}");
}
