//! One array of a rendering: its name, elements, size and content.

use bytemuck::NoUninit;

use crate::kernel::scene::{Binding, Element};
use crate::layout::{BufferUse, GpuStruct, Records};

/// An array that a kernel is to find in its own buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArrayPlan {
    /// The binding that the kernel declares.
    pub binding: Binding,
    /// Size of the buffer.
    pub bytes: u64,
}

impl ArrayPlan {
    /// `count` structs, or room for one: an array has at least one element, in GLSL and so in its buffer.
    pub fn records<T: GpuStruct>(name: &'static str, count: usize, buffer_use: BufferUse) -> Self {
        Self::structs(name, T::NAME, count, size_of::<T>(), buffer_use)
    }

    /// The same, by the name of the struct and its size.
    fn structs(
        name: &'static str,
        ty: &'static str,
        count: usize,
        size: usize,
        buffer_use: BufferUse,
    ) -> Self {
        let binding = Binding {
            name,
            element: Element::Struct(ty),
            count,
            buffer_use,
        };
        let bytes = (count.max(1) * size) as u64;
        Self { binding, bytes }
    }

    /// `count` plain words, always in storage: std140 would spread each over 16 bytes.
    fn words(name: &'static str, element: Element, count: usize) -> Self {
        let binding = Binding {
            name,
            element,
            count,
            buffer_use: BufferUse::Storage,
        };
        let bytes = (count * element.bytes()) as u64;
        Self { binding, bytes }
    }
}

/// An array of a scene. Its content is made on demand: no two are in the host's memory at once.
pub struct SceneArray<'a> {
    pub plan: ArrayPlan,
    make: Box<dyn Fn() -> Box<dyn Content + 'a> + 'a>,
}

/// Records that are about to be uploaded.
pub trait Content {
    fn bytes(&self) -> &[u8];
}

impl<T: NoUninit> Content for Vec<T> {
    fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self)
    }
}

impl<T: NoUninit> Content for &[T] {
    fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self)
    }
}

impl<'a> SceneArray<'a> {
    /// Structs: a uniform if they fit into `uniform_buffer` bytes.
    pub fn records(name: &'static str, records: impl Records + 'a, uniform_buffer: u64) -> Self {
        let (count, size) = (records.count(), records.size());
        let fits = (count.max(1) * size) as u64 <= uniform_buffer;
        let buffer_use = match fits {
            true => BufferUse::Uniform,
            false => BufferUse::Storage,
        };
        Self {
            plan: ArrayPlan::structs(name, records.name(), count, size, buffer_use),
            make: Box::new(move || Box::new(records.bytes())),
        }
    }

    /// The words of `count` records of `T`, which `make` makes.
    pub fn words<T: NoUninit>(
        name: &'static str,
        element: Element,
        count: usize,
        make: impl Fn() -> Vec<T> + 'a,
    ) -> Self {
        let words = count * size_of::<T>() / element.bytes();
        Self {
            plan: ArrayPlan::words(name, element, words),
            make: Box::new(move || Box::new(make())),
        }
    }

    /// The words of existing records.
    pub fn lent<T: NoUninit>(name: &'static str, element: Element, records: &'a [T]) -> Self {
        let words = size_of_val(records) / element.bytes();
        Self {
            plan: ArrayPlan::words(name, element, words),
            make: Box::new(move || Box::new(records)),
        }
    }

    /// Makes the content: as many bytes as planned, or none if the array has no element.
    pub fn content(&self) -> Box<dyn Content + 'a> {
        (self.make)()
    }
}
