//! The kernel and buffers of a rendering and the reasons for them, as a record, and the record as a page to read.

mod page;

pub use page::page;

/// The explanation of a kernel and its buffers.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// The scene file's path as it was given.
    pub scene: String,
    /// Width and height of the full picture.
    pub size: [u32; 2],
    /// Left, top, right, bottom in pixels of the full picture, right and bottom excluded.
    pub crop: Option<[u32; 4]>,
    /// The device whose limits apply.
    pub device: String,
    /// The parts that a kernel may have, in the order of a path: each is in this one, or not.
    pub parts: Vec<Part>,
    /// This kernel, and the full one.
    pub kernels: [KernelSize; 2],
    /// The driver's statistics for this kernel; `None` if not requested.
    pub counts: Option<Vec<Count>>,
    /// In the order of their bindings.
    pub buffers: Vec<Buffer>,
    /// Primitives of all shapes: a triangle, or a shape that is not a mesh.
    pub primitives: usize,
    /// The hierarchy over the primitives that it contains.
    pub hierarchy: Option<Hierarchy>,
    pub memory: Memory,
}

/// A part that some kernels have and others do not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The kind of part: `shape`, `material` …
    pub group: &'static str,
    pub name: String,
    pub present: bool,
    /// The scene's lines that need it, from 1, ascending; none if a flag or default selects it.
    pub lines: Vec<usize>,
    /// Its purpose, or why it is not needed; empty if the lines suffice.
    pub why: String,
    /// The first of the lines.
    pub quote: String,
}

/// The size of a kernel's text and code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KernelSize {
    /// Files of GLSL, and texts made for the scene.
    pub files: usize,
    pub lines: usize,
    pub functions: usize,
    pub spirv_bytes: usize,
    pub instructions: usize,
}

/// One statistic of the driver, with the driver's own name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Count {
    /// The paths that the kernel follows, if there are two kernels.
    pub kernel: &'static str,
    /// Drivers may compile a kernel several times.
    pub executable: String,
    pub name: String,
    pub value: String,
}

/// An array on the device.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Buffer {
    pub name: &'static str,
    /// The GLSL type of its elements.
    pub element: &'static str,
    pub count: usize,
    pub bytes: u64,
    /// A uniform buffer, which is small and read only; else a storage buffer.
    pub uniform: bool,
    /// The kernel writes it.
    pub written: bool,
}

/// A bounding volume hierarchy in figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hierarchy {
    pub nodes: usize,
    pub node_bytes: usize,
    pub primitives: usize,
    /// Entries of a traversal's stack.
    pub stack: u32,
    /// Nodes that a line through the scene's box meets, on average over all such lines.
    pub node_visits: f64,
    /// Primitives that it is tested against.
    pub primitive_tests: f64,
}

/// Expected allocations, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Memory {
    /// All buffers.
    pub device: u64,
    /// The largest tile, and the number of tiles.
    pub tile_pixels: u32,
    pub tiles: usize,
    /// The scene on the host, in f64.
    pub scene: u64,
    /// The peak memory of its triangles, from reading to rendering.
    pub peak: u64,
    /// The films of all tiles on the host.
    pub films: u64,
    /// The picture, and other outputs.
    pub pictures: u64,
}
