//! A kernel's access to a buffer.

/// The layout rules of a buffer, and the kernel's access to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BufferUse {
    /// Small, read only, std140: `layout(std140) uniform`.
    Uniform,
    /// Read and written, std430: `layout(std430) buffer`.
    Storage,
}
