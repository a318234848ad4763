//! `vkpt farm`: the scripts that it writes, run by a Slurm; its refusals; the commands of docs/farm.md.
#![cfg(target_os = "linux")]

mod folder;
mod jobs;
mod page;
mod process;
mod refusals;
mod slurm;
