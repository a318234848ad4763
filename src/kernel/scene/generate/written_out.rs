//! Primitives that are tried one by one, without a loop.
//!
//! On a CPU each is read into a variable of its own before any branch: lavapipe of Mesa 22.3 reads a uniform behind a
//! branch lane by lane, whatever its index (`shaders/integrator/path/path_trace.comp`). A GPU reads it into scalar registers anywhere, and
//! would run out of them if all were read at once: radv spills 436 on `scenes/glass-table.txt`.

use crate::prepared::ShapeKind;

/// How the primitives of a kind are written out.
pub struct WrittenOut {
    /// The array whose length is their number.
    pub array: &'static str,
    /// The file with the test.
    pub file: &'static str,
    ty: &'static str,
    values: &'static str,
    /// Primitive `{i}` in its buffer.
    element: &'static str,
    /// The test of `{x}`.
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
                call: "nearer_sphere(ray, skip, best, {x})",
                before: "",
            },
            ShapeKind::Box => Self {
                array: "boxes",
                file: "shape/linear/box",
                ty: "Cuboid",
                values: "box_values",
                element: "boxes[{i}]",
                call: "nearer_box(ray, skip, best, {x})",
                before: "",
            },
            ShapeKind::Cylinder => Self {
                array: "cylinders",
                file: "shape/linear/cylinder",
                ty: "Cylinder",
                values: "cylinder_values",
                element: "cylinders[{i}]",
                call: "nearer_cylinder(ray, skip, best, {x})",
                before: "",
            },
            ShapeKind::Mesh => Self {
                array: "triangle_shapes",
                file: "shape/triangle/nearer",
                ty: "Triangle",
                values: "triangle_values",
                element: "triangle_at({i}u)",
                call: "nearer_triangle(ray, shear, skip, best, {x}, {i}u)",
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

    /// Reads each primitive from its buffer.
    pub fn read(&self, count: usize) -> String {
        let line = |i| format!("    {} = {};\n", self.copy(i), number(self.element, i));
        (0..count).map(line).collect()
    }

    /// Tries each: its copy, where they were `read_first`.
    pub fn test(&self, count: usize, read_first: bool) -> String {
        let line = |i| {
            let primitive = match read_first {
                true => self.copy(i),
                false => number(self.element, i),
            };
            format!(
                "    best = {};\n",
                number(self.call, i).replace("{x}", &primitive)
            )
        };
        self.before.to_owned() + &(0..count).map(line).collect::<String>()
    }

    fn copy(&self, i: usize) -> String {
        format!("{}[{i}]", self.values)
    }
}

fn number(text: &str, i: usize) -> String {
    text.replace("{i}", &i.to_string())
}
