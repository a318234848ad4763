//! The buffer: vertices and triangles in sequence, each array with its view and accessor.

use glam::DVec3;
use serde_json::{Value, json};

/// glTF's codes for component types.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;

/// glTF's codes for the targets of views.
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// A buffer under construction. All its values are 4 bytes, so all arrays are aligned.
#[derive(Default)]
pub struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Adds points in single precision; returns their accessor.
    pub fn points(&mut self, points: &[DVec3]) -> usize {
        let start = self.bytes.len();
        let points: Vec<[f32; 3]> = points.iter().map(|p| p.as_vec3().to_array()).collect();
        self.bytes
            .extend_from_slice(&little_endian(points.as_flattened(), f32::to_le_bytes));
        // glTF requires the bounds of positions, and allows them for all other accessors.
        let bound = |first: f32, of: fn(f32, f32) -> f32| {
            [0, 1, 2].map(|axis| points.iter().map(|p| p[axis]).fold(first, of))
        };
        let accessor = json!({
            "componentType": FLOAT,
            "type": "VEC3",
            "count": points.len(),
            "min": bound(f32::INFINITY, f32::min),
            "max": bound(f32::NEG_INFINITY, f32::max),
        });
        self.add(start, ARRAY_BUFFER, accessor)
    }

    /// Adds the corners of triangles; returns their accessor.
    pub fn triangles(&mut self, triangles: &[[u32; 3]]) -> usize {
        let start = self.bytes.len();
        let corners = triangles.as_flattened();
        self.bytes
            .extend_from_slice(&little_endian(corners, u32::to_le_bytes));
        let accessor = json!({
            "componentType": UNSIGNED_INT,
            "type": "SCALAR",
            "count": corners.len(),
        });
        self.add(start, ELEMENT_ARRAY_BUFFER, accessor)
    }

    /// Adds an accessor of all data added from `start` on.
    fn add(&mut self, start: usize, target: u32, mut accessor: Value) -> usize {
        accessor["bufferView"] = json!(self.views.len());
        self.views.push(json!({
            "buffer": 0,
            "byteOffset": start,
            "byteLength": self.bytes.len() - start,
            "target": target,
        }));
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    pub fn views(&self) -> &[Value] {
        &self.views
    }

    pub fn accessors(&self) -> &[Value] {
        &self.accessors
    }

    /// Length in bytes.
    pub fn len(&self) -> usize {
        self.bytes.len()
    }

    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }
}

fn little_endian<T: Copy>(values: &[T], bytes: fn(T) -> [u8; 4]) -> Vec<u8> {
    values.iter().flat_map(|value| bytes(*value)).collect()
}
