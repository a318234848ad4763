//! A rendering under way for those who look on: a page that this machine alone can see, and pictures sent to tev.
//!
//! The rendering's own thread makes a snapshot where somebody waits for one, seldom enough not to be felt ([`Onlookers`]), and
//! leaves it. Threads apart from it hand it on; it never waits for them before its end.

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
