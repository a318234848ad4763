//! Transfers the additional sums of a tile's pixels to the device and back.

use super::device_film::{array, parts, vector};
use crate::film::Keeps;
use crate::gpu::Buffer;
use crate::layout;
use crate::part::Beside;
use crate::reference::film::{FilmMoments, FilmQuarters};
use crate::render::RenderError;

/// Writes them to `buffer`, which is of their kind.
pub fn write(beside: &Beside<f32>, buffer: &Buffer) -> Result<(), RenderError> {
    match beside {
        Beside::Nothing => {}
        Beside::Moments(moments) => {
            let kept: Vec<layout::FilmMoments> = moments.iter().map(packed_moments).collect();
            buffer.write(bytemuck::cast_slice(&kept))?;
        }
        Beside::Quarters(quarters) => {
            let kept: Vec<layout::FilmQuarters> = quarters.iter().map(packed_quarters).collect();
            buffer.write(bytemuck::cast_slice(&kept))?;
        }
    }
    Ok(())
}

/// Reads those of this many pixels from `buffer`.
pub fn read(keeps: Keeps, buffer: &Buffer, pixels: usize) -> Result<Beside<f32>, RenderError> {
    Ok(match keeps {
        Keeps::Nothing => Beside::Nothing,
        Keeps::Moments => {
            let mut kept = vec![layout::FilmMoments::default(); pixels];
            buffer.read_into(bytemuck::cast_slice_mut(&mut kept))?;
            Beside::Moments(kept.iter().map(moments).collect())
        }
        Keeps::Quarters => {
            let mut kept = vec![layout::FilmQuarters::default(); pixels];
            buffer.read_into(bytemuck::cast_slice_mut(&mut kept))?;
            Beside::Quarters(kept.iter().map(quarters).collect())
        }
    })
}

fn packed_moments(moments: &FilmMoments<f32>) -> layout::FilmMoments {
    layout::FilmMoments {
        mean: array(moments.mean.sum),
        mean_comp: array(moments.mean.comp),
        m2: array(moments.m2.sum),
        m2_comp: array(moments.m2.comp),
        ..layout::FilmMoments::default()
    }
}

fn moments(kept: &layout::FilmMoments) -> FilmMoments<f32> {
    FilmMoments {
        mean: parts(kept.mean, kept.mean_comp),
        m2: parts(kept.m2, kept.m2_comp),
    }
}

fn quarters(kept: &layout::FilmQuarters) -> FilmQuarters<f32> {
    FilmQuarters {
        even: vector(kept.even),
        odd: vector(kept.odd),
    }
}

fn packed_quarters(quarters: &FilmQuarters<f32>) -> layout::FilmQuarters {
    layout::FilmQuarters {
        even: array(quarters.even),
        odd: array(quarters.odd),
        ..layout::FilmQuarters::default()
    }
}
