//! The cases, a file a group.

mod alpha;
mod bounces;
mod camera;
mod contact;
mod furnace;
mod interface;
mod light;
mod medium;
mod mesh;

use super::case::Case;

/// All of them, group by group.
pub fn battery() -> Vec<Case> {
    let groups = [
        alpha::cases(),
        interface::cases(),
        furnace::cases(),
        medium::cases(),
        light::cases(),
        camera::cases(),
        bounces::cases(),
        contact::cases(),
        mesh::cases(),
    ];
    groups.into_iter().flatten().collect()
}
