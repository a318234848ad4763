//! Builds triangles from the corners of a primitive (glTF 2.0, section 3.7.2.1, *Overview*).

use super::super::left_out::LeftOut;

/// How corners make triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Mode {
    List,
    Strip,
    Fan,
}

impl Mode {
    /// The topology of a mode; `None` for points and lines. Errors are messages.
    pub(super) fn of(code: u64) -> Result<Option<Self>, String> {
        match code {
            0..=3 => Ok(None),
            4 => Ok(Some(Self::List)),
            5 => Ok(Some(Self::Strip)),
            6 => Ok(Some(Self::Fan)),
            _ => Err(format!("its mode {code} is unknown")),
        }
    }

    /// The triangles of `corners`. Triangles of a strip that repeat a corner only join it and are dropped silently;
    /// corners too few for a triangle are omitted and counted.
    pub(super) fn triangles(self, corners: &[u32], left_out: &mut LeftOut) -> Vec<[u32; 3]> {
        let too_few = match self {
            Self::List => corners.len() % 3,
            Self::Strip | Self::Fan if corners.len() < 3 => corners.len(),
            Self::Strip | Self::Fan => 0,
        };
        left_out.faces += usize::from(too_few > 0);
        match self {
            Self::List => corners.as_chunks().0.to_vec(),
            Self::Strip => corners
                .windows(3)
                .enumerate()
                // pᵢ = (vᵢ, vᵢ₊₁₊ᵢ mod ₂, vᵢ₊₂₋ᵢ mod ₂)
                .map(|(i, v)| [v[0], v[1 + i % 2], v[2 - i % 2]])
                .filter(|[a, b, c]| a != b && b != c && c != a)
                .collect(),
            // pᵢ = (vᵢ₊₁, vᵢ₊₂, v₀)
            Self::Fan => corners
                .windows(2)
                .skip(1)
                .map(|v| [v[0], v[1], corners[0]])
                .collect(),
        }
    }
}
