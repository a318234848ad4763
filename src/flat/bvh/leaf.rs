//! Maps references to intersection tests in the kernel: text for the slot `<leaf>`.

use super::reference::{INDEX_BITS, INDEX_MASK};
use crate::shape::{ShapeKind, filled};

/// GLSL that tests the primitive of a reference, for a hierarchy with these kinds: `begin_leaves(ray)`, to be called
/// before the first test, and `nearer_leaf(reference, ray, skip, best)`.
pub fn leaf_text(kinds: impl IntoIterator<Item = ShapeKind>) -> String {
    let kinds: Vec<ShapeKind> = kinds.into_iter().collect();
    let mut head = String::from("// uses: shape/ray");
    let (mut variables, mut begin, mut tests) = (String::new(), String::new(), String::new());
    for &kind in &kinds {
        let shape = kind.description();
        let once = format!("leaf_{}", shape.name);
        head += &format!(", {}", shape.nearer_file);
        if let Some([ty, value]) = shape.once {
            variables += &format!("{ty} {once};\n");
            begin += &format!(" {once} = {value};");
        }
        let condition = match kinds.len() {
            1 => String::new(),
            _ => format!("if (reference >> {INDEX_BITS}u == {}u) ", kind as u32),
        };
        let places = [
            ("{once}", &once[..]),
            ("{best}", "nearest"),
            ("{x}", shape.element),
            ("{i}", "i"),
        ];
        let test = filled(shape.nearer, &places);
        tests += &format!("    {condition}{{ nearest = {test}; }}\n");
    }
    format!(
        "{head}\n{variables}void begin_leaves(Ray ray) {{{begin} }}\n\
         Hit nearer_leaf(uint reference, Ray ray, Target skip, Hit best) {{\n    \
         uint i = reference & {INDEX_MASK}u;\n    Hit nearest = best;\n{tests}    return nearest;\n}}\n"
    )
}
