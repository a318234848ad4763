//! The metrics against closed forms and other programs' numbers; each of them fails on a planted error.

mod blocks;
mod calibration;
mod closed_forms;
mod convergence;
mod estimates;
mod flip;
mod heatmap;
mod noise;
mod pictures;
mod planted;
mod refusals;
