//! Situations that two programs render differently: the eye inside a light, and coincident faces.

use vkpt::prepared::patch::{Orientation, Patch};
use vkpt::prepared::{NONE, Prepared, Shape, ShapeKind};

/// The lines of the lights that contain the eye.
pub fn lights_about_eye(prepared: &Prepared) -> impl Iterator<Item = usize> {
    let lights = prepared.shapes.iter().filter(|shape| shape.light != NONE);
    let around = lights.filter(|shape| contains_eye(prepared, shape));
    around.map(|shape| shape.line)
}

/// For each shape with a face that coincides with one of another shape: both lines.
pub fn coincident(prepared: &Prepared) -> impl Iterator<Item = (usize, usize)> {
    let shapes = prepared.shapes.iter().enumerate();
    shapes.filter_map(|(i, shape)| Some((shape.line, other_in_place(prepared, i, shape)?.line)))
}

fn contains_eye(prepared: &Prepared, shape: &Shape) -> bool {
    let first = shape.first as usize;
    let range = first..first + shape.count as usize;
    let body = prepared.primitives.body(shape.kind, range);
    body.contains(prepared.camera.eye)
}

/// The first shape with a face that coincides with one of this shape, if rays may hit it there.
fn other_in_place<'a>(prepared: &'a Prepared, i: usize, shape: &Shape) -> Option<&'a Shape> {
    let coincident = &prepared.primitives.coincident;
    let listed = (shape.faces()).find_map(|prim| coincident.of(i as u32, prim).first());
    match listed {
        Some(face) => Some(&prepared.shapes[face.shape as usize]),
        None => (prepared.shapes[..i].iter()).find(|other| flush_boxes(prepared, shape, other)),
    }
}

/// Boxes of two materials with faces in one plane, seen from one side. vkpt needs no table to decide between them.
fn flush_boxes(prepared: &Prepared, a: &Shape, b: &Shape) -> bool {
    let boxes = [a, b].iter().all(|shape| shape.kind == ShapeKind::Box);
    if !boxes || a.material == b.material {
        return false;
    }
    let [a, b] = [a, b].map(|shape| &prepared.primitives.boxes[shape.first as usize]);
    let apart = a.lo.max(b.lo).cmpgt(a.hi.min(b.hi)).any();
    if apart {
        return false;
    }
    let [a, b] = [a, b].map(Patch::cuboid);
    let flush = |p: &Patch| (b.iter()).any(|q| p.coincides(q) == Some(Orientation::Same));
    a.iter().any(flush)
}
