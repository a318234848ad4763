//! The metrics against closed forms and other programs' numbers; each of them fails on a planted error.

mod blocks;
mod calibration;
mod closed_forms;
mod convergence;
mod denoised;
mod denoised_renderings;
mod estimates;
mod flip;
mod heatmap;
mod noise;
pub mod pictures;
mod planted;
mod refusals;
