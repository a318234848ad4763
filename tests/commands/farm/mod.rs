//! `vkpt farm`: the scripts that it writes, by a Slurm and by what it refuses; the commands of docs/farm.md.
#![cfg(target_os = "linux")]

mod folder;
mod jobs;
mod page;
mod process;
mod refusals;
mod slurm;
