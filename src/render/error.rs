//! Errors of a rendering.

use crate::features::Features;
use crate::gpu::GpuError;
use crate::kernel::KernelError;

/// Why a rendering failed.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    #[error(transparent)]
    Gpu(#[from] GpuError),
    #[error(
        "the kernel of this scene does not compile, which is a bug in vkpt or in a shader file given to it:\n{error}\n\
         Its features: {features}"
    )]
    Kernel {
        #[source]
        error: KernelError,
        features: Box<Features>,
    },
    #[error(
        "the driver ended loops of {0} paths early: the picture would be wrong. \
         Try another driver, or --device cpu-f32"
    )]
    Loops(u64),
    #[error(
        "the films of the picture take {:.1} GiB of memory, but only {:.1} GiB are free: use --size or --crop for a smaller picture",
        gib(*.needed), gib(*.free)
    )]
    Memory { needed: u64, free: u64 },
    #[error(
        "the earlier samples have another size or precision, or lack the data for standard errors"
    )]
    Start,
    #[error("the device failed twice: {0}")]
    Twice(Box<RenderError>),
}

fn gib(bytes: u64) -> f64 {
    bytes as f64 / f64::from(1 << 30)
}

impl RenderError {
    /// Whether a device opened anew may succeed.
    pub(super) fn is_loss(&self) -> bool {
        matches!(self, Self::Gpu(error) if error.is_loss())
    }

    /// Whether there is no such device, rather than one that failed.
    pub fn is_no_device(&self) -> bool {
        matches!(
            self,
            Self::Gpu(
                GpuError::NoVulkan(_) | GpuError::NoSuchDevice { .. } | GpuError::Unusable { .. }
            )
        )
    }
}
