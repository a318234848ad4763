//! A scene in the words of other programs: a folder each. What such a program has no equal of is refused, by line; where it
//! has another model of the same thing, that is said. docs/exchange.md has all of both.

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

/// What is to be said in another renderer's words.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    pub scene: &'a Scene,
    /// The same, by the settings and at the size of the picture.
    pub prepared: &'a Prepared,
    pub model: &'a Model,
    /// First column and row, then those behind the last, from the top left.
    pub crop: Option<[u32; 4]>,
    /// What the names of files beside the scene begin with.
    pub stem: &'a str,
}

/// What the other renderer reads.
#[derive(Clone, Debug)]
pub struct Export {
    text: Text,
    /// To stand beside the scene, which has their names.
    pub beside: Vec<Beside>,
    /// Where the picture will not be quite the same, each once, in the order of the file.
    pub warnings: Vec<Remark<String>>,
    /// What is good to know.
    pub note: Option<Remark<String>>,
}

#[derive(Clone, Debug)]
enum Text {
    Xml(Node),
    Bytes(Vec<u8>),
}

/// A file to stand beside the scene.
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
