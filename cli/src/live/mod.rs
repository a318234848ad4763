//! The live view of a rendering: a page that only this machine can see, and pictures sent to tev.
//!
//! The rendering's own thread makes a snapshot if somebody waits for one, rarely enough to cost little ([`Viewers`]), and
//! continues. Separate threads deliver it; the rendering never waits for them before its end.

mod answer;
mod board;
mod clock;
pub mod command;
mod gate;
mod pace;
mod page;
mod server;
mod snapshot;
mod state;
mod tabs;
mod tev;
mod viewers;

pub use board::Board;
pub use server::{Server, listen};
pub use tev::{Address, Tev};
pub use viewers::Viewers;
