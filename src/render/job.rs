//! What is to be rendered, and by what.

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

/// What renders.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    Vulkan(Selector),
    CpuF32,
    CpuF64,
}

/// Which kernel renders on a Vulkan device. The picture does not depend on it, but for files of one's own; the reference
/// has none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KernelChoice<'a> {
    /// What scene and settings need, and nothing else.
    #[default]
    Composed,
    /// What any scene could need: [`Features::full`].
    Full,
    /// These features, which must hold what scene and settings need.
    Given(&'a Features),
    /// What scene and settings need, with files of one's own in place of some of `shaders/`: another estimator, say,
    /// to be measured beside vkpt's by [`converge`](vkpt_lab::converge). [`file`](crate::kernel::file) has vkpt's text. A
    /// file that the kernel does not use is an error.
    Own(&'a [OwnFile<'a>]),
}

/// What is to be rendered.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    pub prepared: &'a Prepared,
    pub settings: Settings,
    /// Samples in every pixel; of a part of them ([`Start::At`]) the index that they end before.
    pub spp: u32,
    /// When to end before all of them are there.
    pub until: Until,
    pub seed: u32,
    /// Left, top, right, bottom in pixels from the top left, right and bottom excluded; within the picture
    /// and not empty.
    pub crop: Option<[u32; 4]>,
    /// What to make beside the picture, which it does not change.
    pub aovs: &'a [Aov],
    /// Classes of paths to split it into.
    pub classes: &'a [PathClass],
    pub kernel: KernelChoice<'a>,
}

impl Job<'_> {
    /// What the kernel of this job holds.
    pub fn features(&self) -> Features {
        match self.kernel {
            KernelChoice::Composed | KernelChoice::Own(_) => {
                Features::of(self.prepared, &self.settings, self.aovs)
            }
            KernelChoice::Full => Features::full(&self.settings, self.aovs),
            KernelChoice::Given(features) => features.clone(),
        }
    }

    /// What stands in place of shader files of vkpt's.
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

    /// A sample of this rendering.
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
