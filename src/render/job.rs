//! A rendering job: scene, settings and device.

use super::course::Until;
use super::tiles::Tile;
use crate::features::Features;
use crate::film::Aov;
use crate::gpu::Selector;
use crate::kernel::OwnFile;
use crate::path_class::PathClass;
use crate::prepared::Prepared;
use crate::reference::path::SampleId;
use crate::sample::Address;
use crate::settings::Settings;

/// The renderer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    Vulkan(Selector),
    CpuF32,
    CpuF64,
}

/// The kernel that renders on a Vulkan device. The picture depends on it only through custom files;
/// the reference has none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KernelChoice<'a> {
    /// The needs of scene and settings, and nothing else.
    #[default]
    Composed,
    /// The needs of any scene: [`Features::full`].
    Full,
    /// These features, which must include the needs of scene and settings.
    Given(&'a Features),
    /// The needs of scene and settings, with custom files in place of some of `shaders/`: another estimator, say, to be
    /// compared with vkpt's by vkpt-lab's `converge`. [`file`](crate::kernel::file) returns vkpt's text. A file
    /// that the kernel does not use is an error.
    Own(&'a [OwnFile<'a>]),
}

/// A picture to be rendered.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    pub prepared: &'a Prepared,
    pub settings: Settings,
    /// Samples in every pixel; for a part of them (`Start::At`) the index before which they end.
    pub spp: u32,
    /// When to end before all of them are complete.
    pub until: Until,
    pub seed: u32,
    /// Left, top, right, bottom in pixels from the top left, right and bottom excluded; within
    /// the picture and not empty.
    pub crop: Option<[u32; 4]>,
    /// What to make in addition to the picture, which it does not change.
    pub aovs: &'a [Aov],
    /// Classes of paths to split it into.
    pub classes: &'a [PathClass],
    pub kernel: KernelChoice<'a>,
}

impl Job<'_> {
    /// The features of this job's kernel.
    pub fn features(&self) -> Features {
        match self.kernel {
            KernelChoice::Composed | KernelChoice::Own(_) => {
                Features::of(self.prepared, &self.settings, self.aovs)
            }
            KernelChoice::Full => Features::full(&self.settings, self.aovs),
            KernelChoice::Given(features) => features.clone(),
        }
    }

    /// The files that replace shader files of vkpt's.
    pub(super) fn own_files(&self) -> &[OwnFile<'_>] {
        match self.kernel {
            KernelChoice::Own(files) => files,
            _ => &[],
        }
    }

    /// Width and height of the picture, or of its crop.
    pub fn size(&self) -> [u32; 2] {
        [self.area().width, self.area().height]
    }

    /// One sample of this rendering.
    pub(super) fn sample(
        &self,
        Address {
            pixel: [column, row],
            index,
        }: Address,
    ) -> SampleId {
        SampleId {
            column,
            row,
            pixel: row * self.prepared.camera.width + column,
            sample: index,
            seed: self.seed,
        }
    }

    /// All pixels of the picture.
    pub(super) fn whole(&self) -> Tile {
        Tile {
            x: 0,
            y: 0,
            width: self.prepared.camera.width,
            height: self.prepared.camera.height,
        }
    }

    /// The pixels to be rendered.
    pub(super) fn area(&self) -> Tile {
        let [left, top, right, bottom] = self.crop.unwrap_or([
            0,
            0,
            self.prepared.camera.width,
            self.prepared.camera.height,
        ]);
        Tile {
            x: left,
            y: top,
            width: right - left,
            height: bottom - top,
        }
    }
}
