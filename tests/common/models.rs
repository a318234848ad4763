//! glTF files as scenes, written by the tests.

use serde_json::{Value, json};

use super::gltf_writer::{Buffer, F32, U16, glb};

/// A document of boxes and squares, each a mesh of its own node with its own material.
pub struct Model {
    pub document: Value,
    buffer: Buffer,
}

impl Model {
    /// Only a camera at `eye` that looks down −Z; yfov is twice the angle whose tangent is `ry`.
    pub fn seen_from(eye: [f64; 3], ry: f64) -> Self {
        let mut model = Self::unseen();
        let perspective = json!({"yfov": 2.0 * ry.atan(), "aspectRatio": 1, "znear": 0.01});
        model.document["cameras"] = json!([{"type": "perspective", "perspective": perspective}]);
        model.add_node(json!({"camera": 0, "translation": eye, "name": "Eye"}));
        model
    }

    /// Nothing at all.
    pub fn unseen() -> Self {
        let document = json!({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}],
            "nodes": [], "meshes": [], "materials": [],
        });
        Self {
            document,
            buffer: Buffer::default(),
        }
    }

    /// Adds a node to the scene and returns its number.
    pub fn add_node(&mut self, node: Value) -> usize {
        let number = self.push("nodes", node);
        let nodes = self.document["scenes"][0]["nodes"].as_array_mut();
        nodes.expect("nodes").push(json!(number));
        number
    }

    fn push(&mut self, array: &str, element: Value) -> usize {
        let array = self.document[array].as_array_mut().expect(array);
        array.push(element);
        array.len() - 1
    }

    /// Adds a closed box between two corners; returns its node.
    pub fn cuboid(&mut self, lo: [f64; 3], hi: [f64; 3], material: Value) -> usize {
        let ends = [lo, hi];
        let corner = |i: usize| [0, 1, 2].map(|k| ends[i >> k & 1][k]);
        let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
        // Anticlockwise from outside; bit 0 is x, bit 1 y, bit 2 z.
        let faces = [
            [0, 4, 6, 2],
            [1, 3, 7, 5],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 2, 3, 1],
            [4, 5, 7, 6],
        ];
        let triangles = faces.map(|[a, b, c, d]| [a, b, c, a, c, d]);
        self.mesh(&corners, triangles.as_flattened(), material)
    }

    /// Adds a mesh at its own node; returns the node.
    pub fn mesh(&mut self, corners: &[[f64; 3]], indices: &[u32], material: Value) -> usize {
        let positions = self.buffer.vectors(F32, corners);
        let indices = self.buffer.scalars(U16, indices);
        let material = self.push("materials", material);
        let primitive = json!({
            "attributes": {"POSITION": positions}, "indices": indices, "material": material,
        });
        let mesh = self.push("meshes", json!({"primitives": [primitive]}));
        self.add_node(json!({"mesh": mesh}))
    }

    /// Adds a light of KHR_lights_punctual at `place`.
    pub fn light(&mut self, place: [f64; 3], light: Value) {
        let extensions = &mut self.document["extensions"]["KHR_lights_punctual"]["lights"];
        if extensions.is_null() {
            *extensions = json!([]);
        }
        let all = extensions.as_array_mut().expect("lights");
        all.push(light);
        let number = all.len() - 1;
        let extensions = json!({"KHR_lights_punctual": {"light": number}});
        self.add_node(json!({"translation": place, "extensions": extensions}));
    }

    /// The document with its buffer, whose data a GLB has, and a `.gltf` at the URI.
    pub fn whole(&self, uri: Option<&str>) -> Value {
        let mut document = self.document.clone();
        document["buffers"] = json!([{"byteLength": self.buffer.bytes.len()}]);
        if let Some(uri) = uri {
            document["buffers"][0]["uri"] = json!(uri);
        }
        document["bufferViews"] = json!(self.buffer.views);
        document["accessors"] = json!(self.buffer.accessors);
        document
    }

    pub fn bytes(&self) -> &[u8] {
        &self.buffer.bytes
    }

    pub fn glb(&self) -> Vec<u8> {
        glb(&self.whole(None), &self.buffer.bytes)
    }
}

/// A diffuse material that mirrors nothing.
pub fn matte(base: [f64; 3]) -> Value {
    json!({
        "pbrMetallicRoughness": {"baseColorFactor": [base[0], base[1], base[2], 1], "metallicFactor": 0},
        "extensions": {"KHR_materials_specular": {"specularFactor": 0}},
    })
}

/// A material that emits and is black otherwise.
pub fn lamp(radiance: f64) -> Value {
    let mut lamp = matte([0.0; 3]);
    lamp["emissiveFactor"] = json!([1, 1, 1]);
    lamp["doubleSided"] = json!(true);
    lamp["extensions"]["KHR_materials_emissive_strength"] = json!({"emissiveStrength": radiance});
    lamp
}

/// Smooth glass of index 1.5 that lets through so much of the light over `distance`.
pub fn glass(colour: [f64; 3], distance: f64) -> Value {
    json!({
        "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
        "extensions": {
            "KHR_materials_transmission": {"transmissionFactor": 1},
            "KHR_materials_volume":
                {"thicknessFactor": 1, "attenuationColor": colour, "attenuationDistance": distance},
        },
    })
}
