//! The diffuse lobe, and its share in a material that has others too.

pub mod lambert;
pub mod mixed;
