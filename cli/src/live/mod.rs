//! The live view of a rendering: a page that only this machine can see, and pictures sent to tev.
//!
//! The rendering's own thread makes a snapshot if somebody waits for one, rarely enough to cost little ([`Onlookers`]), and
//! continues. Separate threads deliver it; the rendering never waits for them before its end.

mod answer;
mod board;
mod clock;
pub mod command;
mod gate;
mod onlookers;
mod pace;
mod page;
mod server;
mod snapshot;
mod state;
mod tabs;
mod tev;

pub use board::Board;
pub use onlookers::Onlookers;
pub use server::{Server, listen};
pub use tev::{Address, Tev};
