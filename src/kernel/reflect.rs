//! The memory layout that naga gives to a kernel's structs, for comparison with [`layout`](crate::layout).

use naga::TypeInner;

use super::compile::{caught, module};
use super::composed::Composed;
use super::error::KernelError;

/// A struct as the kernel sees it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StructLayout {
    pub name: String,
    /// Bytes from one element to the next in an array.
    pub size: u32,
    pub members: Vec<Member>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Member {
    pub name: String,
    /// Bytes from the start of the struct.
    pub offset: u32,
}

/// All named structs that the kernel reaches, including buffer blocks.
pub fn struct_layouts(kernel: &Composed) -> Result<Vec<StructLayout>, KernelError> {
    caught(|| {
        let (module, _) = module(kernel)?;
        Ok(module
            .types
            .iter()
            .filter_map(|(_, ty)| layout(ty))
            .collect())
    })
}

fn layout(ty: &naga::Type) -> Option<StructLayout> {
    let TypeInner::Struct { members, span } = &ty.inner else {
        return None;
    };
    let member = |m: &naga::StructMember| Member {
        name: m.name.clone().unwrap_or_default(),
        offset: m.offset,
    };
    Some(StructLayout {
        name: ty.name.clone()?,
        size: *span,
        members: members.iter().map(member).collect(),
    })
}
