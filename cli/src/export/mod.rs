//! Exports a scene to other programs, one folder each. Features without an equivalent are refused, by line; differences
//! between the models give a warning. docs/exchange.md lists both.

pub mod command;
pub mod gltf;
mod mesh;
pub mod mitsuba;
pub mod pbrt;
mod place;
mod remark;
mod seen;

use std::io::{self, Write};

use mitsuba::Node;
pub use remark::Remark;

use vkpt::prepared::Prepared;
use vkpt::scene::Scene;
use vkpt::settings::Model;

/// The scene to export.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    pub scene: &'a Scene,
    /// The scene prepared with the settings and at the size of the picture.
    pub prepared: &'a Prepared,
    pub model: &'a Model,
    /// First column and row, then one past the last, from the top left.
    pub crop: Option<[u32; 4]>,
    /// The prefix of the names of additional files.
    pub stem: &'a str,
}

/// The input for the other renderer.
#[derive(Clone, Debug)]
pub struct Export {
    text: Text,
    /// Additional files, which the scene refers to by name.
    pub beside: Vec<Beside>,
    /// Differences of the pictures, each once, in file order.
    pub warnings: Vec<Remark<String>>,
    /// A note for the user.
    pub note: Option<Remark<String>>,
}

#[derive(Clone, Debug)]
enum Text {
    Xml(Node),
    Bytes(Vec<u8>),
}

/// An additional file.
#[derive(Clone, Debug)]
pub struct Beside {
    pub name: String,
    pub bytes: Vec<u8>,
}

impl Export {
    /// Writes the scene.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        match &self.text {
            Text::Xml(root) => root.write(out),
            Text::Bytes(bytes) => out.write_all(bytes),
        }
    }
}
