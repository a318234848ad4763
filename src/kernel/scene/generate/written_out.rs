//! Primitives that are tried one by one: no loop, no index, each in a variable of its own.

use crate::prepared::ShapeKind;

/// How the primitives of a kind are written out.
pub struct WrittenOut {
    /// The array whose length is their number.
    pub array: &'static str,
    /// The file with the test.
    pub file: &'static str,
    ty: &'static str,
    values: &'static str,
    /// What stands for `{i}`: the primitive in its buffer, and the test of its copy.
    element: &'static str,
    call: &'static str,
    /// What comes before the tests.
    before: &'static str,
}

impl WrittenOut {
    pub fn new(kind: ShapeKind) -> Self {
        match kind {
            ShapeKind::Sphere => Self {
                array: "spheres",
                file: "shape/linear/sphere",
                ty: "Sphere",
                values: "sphere_values",
                element: "spheres[{i}]",
                call: "nearer_sphere(ray, skip, best, sphere_values[{i}])",
                before: "",
            },
            ShapeKind::Box => Self {
                array: "boxes",
                file: "shape/linear/box",
                ty: "Cuboid",
                values: "box_values",
                element: "boxes[{i}]",
                call: "nearer_box(ray, skip, best, box_values[{i}])",
                before: "",
            },
            ShapeKind::Cylinder => Self {
                array: "cylinders",
                file: "shape/linear/cylinder",
                ty: "Cylinder",
                values: "cylinder_values",
                element: "cylinders[{i}]",
                call: "nearer_cylinder(ray, skip, best, cylinder_values[{i}])",
                before: "",
            },
            ShapeKind::Mesh => Self {
                array: "triangle_shapes",
                file: "shape/triangle/nearer",
                ty: "Triangle",
                values: "triangle_values",
                element: "triangle_at({i}u)",
                call: "nearer_triangle(ray, shear, skip, best, triangle_values[{i}], {i}u)",
                before: "    RayShear shear = ray_shear(ray.d);\n",
            },
        }
    }

    /// Declares the variables; there is no array of no elements.
    pub fn copies(&self, count: usize) -> String {
        match count {
            0 => String::new(),
            _ => format!("{} {}[{count}];\n", self.ty, self.values),
        }
    }

    /// Reads each from its buffer.
    pub fn read(&self, count: usize) -> String {
        let line = |i: usize| format!("    {}[{i}] = {};\n", self.values, number(self.element, i));
        (0..count).map(line).collect()
    }

    /// Tries each.
    pub fn test(&self, count: usize) -> String {
        let line = |i: usize| format!("    best = {};\n", number(self.call, i));
        self.before.to_owned() + &(0..count).map(line).collect::<String>()
    }
}

fn number(text: &str, i: usize) -> String {
    text.replace("{i}", &i.to_string())
}
