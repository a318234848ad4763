//! Features of the visible surfaces, which have little noise: where they change, light may change.

use crate::film::{Channel, Film};

/// Albedo in [0, 1] and normal of the first surface that scatters, behind mirrors and smooth glass.
#[derive(Clone, Debug, PartialEq)]
pub struct Features {
    pub albedo: Film,
    pub normal: Film,
}

impl Features {
    /// From the layers `albedo*` and `normal*` of a picture of this size; `None` if one is missing.
    pub fn new(layers: &[Channel], [width, height]: [u32; 2]) -> Option<Self> {
        let film = |names: [&str; 3]| {
            let channel = |name: &str| layers.iter().find(|channel| channel.name == name);
            let [x, y, z] = names.map(channel);
            let (x, y, z) = (&x?.values, &y?.values, &z?.values);
            let rgb = x.iter().zip(y).zip(z).map(|((&x, &y), &z)| [x, y, z]);
            Some(Film {
                width,
                height,
                rgb: rgb.collect(),
            })
        };
        Some(Self {
            albedo: film(["AlbedoBehind.R", "AlbedoBehind.G", "AlbedoBehind.B"])?,
            normal: film(["NsBehind.X", "NsBehind.Y", "NsBehind.Z"])?,
        })
    }
}
