//! How a kernel sees a buffer.

/// Which rules lay a buffer out, and what a kernel may do with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BufferUse {
    /// Small, read only, std140: `layout(std140) uniform`.
    Uniform,
    /// Read and written, std430: `layout(std430) buffer`.
    Storage,
}
