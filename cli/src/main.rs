//! vkpt renders a scene file to pictures on a Vulkan device, or on the CPU.
//!
//! The data flow:
//!
//! 1. `scene` reads text and meshes into a `Scene`: names, units, f64;
//! 2. `prepared` derives everything that both renderers share;
//! 3. `render` turns it into a `Film`: composed kernels (`features`, `flat`, `kernel`) on a device (`gpu`), or the CPU
//!    reference (`reference`);
//! 4. `image` writes the film, `report` the record of the rendering.
//!
//! `cli` knows them all; none of them knows `cli`, and only `cli` prints.

use std::process::ExitCode;

fn main() -> ExitCode {
    vkpt_cli::run(std::env::args_os()).into()
}
