//! The cases, a file for each group.

mod alpha;
mod angle;
mod beyond;
mod bounces;
mod camera;
mod coincident;
mod contact;
mod far;
mod furnace;
mod interface;
mod lens;
mod light;
mod medium;
mod mesh;
mod surroundings;
mod yardstick;

use super::case::Case;

/// All cases, group by group.
pub fn battery() -> Vec<Case> {
    let groups = [
        alpha::cases(),
        angle::cases(),
        interface::cases(),
        furnace::cases(),
        yardstick::cases(),
        far::cases(),
        medium::cases(),
        light::cases(),
        surroundings::cases(),
        camera::cases(),
        lens::cases(),
        bounces::cases(),
        contact::cases(),
        coincident::cases(),
        mesh::cases(),
        beyond::cases(),
    ];
    groups.into_iter().flatten().collect()
}
