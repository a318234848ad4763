//! What a rendering would bring to a device and why, as a record, and the record as a page to read.

mod page;

pub use page::page;

/// A kernel explained, with all that goes with it.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// The scene file's path as it was given.
    pub scene: String,
    /// Width and height of the full picture.
    pub size: [u32; 2],
    /// Left, top, right, bottom in pixels of the full picture, right and bottom excluded.
    pub crop: Option<[u32; 4]>,
    /// Whose limits count.
    pub device: String,
    /// What a kernel may hold, in the order of a path: each is in this one, or left out.
    pub parts: Vec<Part>,
    /// This kernel, and the one that holds all there is.
    pub kernels: [KernelSize; 2],
    /// What the driver counts of its code for this kernel; `None` where that was not asked.
    pub counts: Option<Vec<Count>>,
    /// In the order of their bindings.
    pub buffers: Vec<Buffer>,
    /// Primitives of all shapes: a triangle, or a shape that is no mesh.
    pub primitives: usize,
    /// Over those that are searched by it.
    pub hierarchy: Option<Hierarchy>,
    pub memory: Memory,
}

/// Something that some kernels hold and others do not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// What it is one of several of: `shape`, `material` …
    pub group: &'static str,
    pub name: String,
    pub present: bool,
    /// The scene's lines that bring it in, from 1, rising; none where a flag or a default does.
    pub lines: Vec<usize>,
    /// What it is there for, or why it is not needed; empty where the lines say it all.
    pub why: String,
    /// The first of the lines.
    pub quote: String,
}

/// How much text and code a kernel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KernelSize {
    /// Files of GLSL, and texts made for the scene.
    pub files: usize,
    pub lines: usize,
    pub functions: usize,
    pub spirv_bytes: usize,
    pub instructions: usize,
}

/// One number of a driver's code, by the driver's own name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Count {
    /// Which paths the kernel follows, where there are two.
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

/// What is going to be allocated, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Memory {
    /// All buffers.
    pub device: u64,
    /// The largest tile, and how many there are.
    pub tile_pixels: u32,
    pub tiles: usize,
    /// The scene on the host, in f64.
    pub scene: u64,
    /// The most that its triangles take at once, from reading to rendering.
    pub peak: u64,
    /// The films of all tiles on the host.
    pub films: u64,
    /// The picture, and what is made beside it.
    pub pictures: u64,
}
