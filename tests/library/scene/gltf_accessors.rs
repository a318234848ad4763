//! Accessors of glTF files: every type of number, sparse or between other things.

use glam::DVec3;
use serde_json::{Value, json};

use super::gltf::{CORNERS, one, read, square, vectors};
use crate::common::gltf_writer::{Buffer, F32, I8, I16, U8, U16};

/// The positions and normals that are read of a triangle of accessors of a buffer.
fn triangle(buffer: &Buffer, attributes: Value) -> (Vec<DVec3>, Option<Vec<DVec3>>) {
    let mut document = one(buffer, json!({"attributes": attributes}));
    document["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    let mesh = read(&document, &buffer.bytes).expect("a mesh");
    assert_eq!(mesh.triangles, [[0, 1, 2]]);
    assert!(mesh.warnings.is_empty(), "{:?}", mesh.warnings);
    (mesh.positions, mesh.normals)
}

/// Bytes of a buffer that are read in other ways: between others, as whole numbers, sparsely.
#[test]
fn accessors_of_every_kind() {
    let mut buffer = square();
    let small = buffer.vectors(
        I8,
        &[
            [0., 0., 0.],
            [127., 0., 0.],
            [127., -128., 0.],
            [0., 64., 0.],
        ],
    );
    let few = buffer.scalars(U8, &[1, 3]);
    let new = buffer.vectors(F32, &[[5., 5., 5.], [7., 7., 7.]]);
    let wide = buffer.interleaved(F32, &CORNERS, 20);
    let (views, position) = (buffer.accessors.clone(), |i: usize| json!({"POSITION": i}));
    let view = |i: usize| views[i]["bufferView"].clone();
    let sparse = json!({
        "count": 2, "values": {"bufferView": view(new)},
        "indices": {"bufferView": view(few), "componentType": U8},
    });
    let mut next = buffer.accessors.len();
    let mut add = |mut accessor: Value, change: Value| {
        for (name, value) in change.as_object().expect("an object") {
            accessor[name] = value.clone();
        }
        buffer.accessors.push(accessor);
        next += 1;
        next - 1
    };
    let normalised = add(views[small].clone(), json!({"normalized": true}));
    let patched = add(views[0].clone(), json!({"sparse": sparse}));
    let zeros = json!({"count": 4, "type": "VEC3", "componentType": F32});
    let from_zero = add(zeros, json!({"sparse": sparse}));
    let z = [0., 0., 0.];
    let rows = [
        (wide, CORNERS),
        (small, [z, [127., 0., 0.], [127., -128., 0.], [0., 64., 0.]]),
        (
            normalised,
            [z, [1., 0., 0.], [1., -1., 0.], [0., 64. / 127., 0.]],
        ),
        (patched, [z, [5., 5., 5.], CORNERS[2], [7., 7., 7.]]),
        (from_zero, [z, [5., 5., 5.], z, [7., 7., 7.]]),
    ];
    for (accessor, expected) in rows {
        let primitive = json!({"attributes": position(accessor), "indices": 1});
        let mesh = read(&one(&buffer, primitive), &buffer.bytes).expect("a mesh");
        assert_eq!(mesh.positions, vectors(&expected), "accessor {accessor}");
    }
}

/// KHR_mesh_quantization: a whole number is itself, or c/(2ᵇ − 1), or max(c/(2ᵇ⁻¹ − 1), −1).
#[test]
fn whole_numbers_may_be_normalised_and_apart() {
    let rows = [
        (
            I8,
            [[-128., -127., 0.], [1., 64., 127.], [0., 0., 5.]],
            127.0,
        ),
        (U8, [[0., 1., 51.], [128., 254., 255.], [0., 0., 5.]], 255.0),
        (
            I16,
            [[-32768., -32767., 0.], [1., 300., 32767.], [0., 0., 5.]],
            32767.0,
        ),
        (
            U16,
            [[0., 1., 300.], [3., 65534., 65535.], [0., 0., 5.]],
            65535.0,
        ),
    ];
    for (kind, numbers, most) in rows {
        let plain = vectors(&numbers);
        let normalised = vectors(&numbers.map(|row| row.map(|c: f64| (c / most).max(-1.0))));
        for stride in [12, 16, 24] {
            let mut buffer = Buffer::default();
            let i = buffer.interleaved(kind, &numbers, stride);
            let attributes = json!({"POSITION": i});
            let (positions, _) = triangle(&buffer, attributes.clone());
            assert_eq!(positions, plain, "{kind}, {stride}");
            buffer.accessors[i]["normalized"] = json!(true);
            let (positions, _) = triangle(&buffer, attributes);
            assert_eq!(positions, normalised, "{kind}, {stride}");
        }
    }
}

#[test]
fn normals_may_be_whole_numbers() {
    for (kind, most) in [(I8, 127.0), (I16, 32767.0)] {
        let mut buffer = Buffer::default();
        buffer.vectors(F32, &CORNERS[..3]);
        let i = buffer.interleaved(
            kind,
            &[[most, 0., 0.], [0., -most, 0.], [most, 0., most]],
            12,
        );
        buffer.accessors[i]["normalized"] = json!(true);
        let (_, normals) = triangle(&buffer, json!({"POSITION": 0, "NORMAL": i}));
        let half = 0.5_f64.sqrt();
        let expected = [DVec3::X, DVec3::NEG_Y, DVec3::new(half, 0.0, half)];
        for (n, e) in normals.expect("normals").iter().zip(expected) {
            assert!(n.distance(e) < 1e-15, "{n} {e}");
        }
    }
}

/// Where elements are packed some exporters write a stride of 0.
#[test]
fn a_stride_of_zero_is_none() {
    let mut buffer = square();
    buffer.views[0]["byteStride"] = json!(0);
    let primitive = json!({"attributes": {"POSITION": 0}, "indices": 1});
    let mesh = read(&one(&buffer, primitive), &buffer.bytes).expect("a mesh");
    assert_eq!(mesh.positions, vectors(&CORNERS));
}
