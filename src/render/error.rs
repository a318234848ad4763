//! Why there is no picture.

use crate::features::Features;
use crate::gpu::GpuError;
use crate::kernel::KernelError;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    #[error(transparent)]
    Gpu(#[from] GpuError),
    #[error(
        "the kernel of this scene does not compile, which is a mistake of vkpt's or in a shader file given to it:\n{error}\n\
         It was to hold {features}"
    )]
    Kernel {
        #[source]
        error: KernelError,
        features: Box<Features>,
    },
    #[error(
        "the driver ended loops of {0} paths before their end: the picture would be wrong. \
         Try another driver, or --device cpu-f32"
    )]
    Loops(u64),
    #[error(
        "the films of the picture take {:.1} GiB of memory, and {:.1} GiB are free: --size or --crop make them smaller",
        gib(*.needed), gib(*.free)
    )]
    Memory { needed: u64, free: u64 },
    #[error(
        "what was rendered before is of another size, of another scalar, or lacks what standard errors are made from"
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
