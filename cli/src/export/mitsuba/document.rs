//! Elements of Mitsuba's XML: plugins, their parameters, and references from one to another.

use std::io::{self, Write};

use glam::{DMat4, DVec3};
use quick_xml::Writer;

/// An element.
#[derive(Clone, Debug)]
pub struct Node {
    tag: &'static str,
    attributes: Vec<(&'static str, String)>,
    children: Vec<Node>,
}

impl Node {
    pub fn new(tag: &'static str) -> Self {
        Self {
            tag,
            attributes: Vec::new(),
            children: Vec::new(),
        }
    }

    /// `<tag type="kind">`: the plugin `kind` in the role `tag`.
    pub fn plugin(tag: &'static str, kind: &str) -> Self {
        Self::new(tag).attribute("type", kind)
    }

    pub fn attribute(mut self, name: &'static str, value: impl ToString) -> Self {
        self.attributes.push((name, value.to_string()));
        self
    }

    pub fn with(mut self, child: Self) -> Self {
        self.children.push(child);
        self
    }

    pub fn with_all(mut self, children: impl IntoIterator<Item = Self>) -> Self {
        self.children.extend(children);
        self
    }

    /// A parameter: `<tag name="…" value="…"/>`.
    fn parameter(self, tag: &'static str, name: &str, value: impl ToString) -> Self {
        let parameter = Self::new(tag).attribute("name", name);
        self.with(parameter.attribute("value", value))
    }

    pub fn float(self, name: &str, value: f64) -> Self {
        self.parameter("float", name, value)
    }

    pub fn integer(self, name: &str, value: impl Into<i64>) -> Self {
        self.parameter("integer", name, value.into())
    }

    pub fn boolean(self, name: &str, value: bool) -> Self {
        self.parameter("boolean", name, value)
    }

    pub fn string(self, name: &str, value: &str) -> Self {
        self.parameter("string", name, value)
    }

    /// Linear RGB with sRGB's primaries.
    pub fn rgb(self, name: &str, value: DVec3) -> Self {
        self.parameter("rgb", name, spaced(&value.to_array()))
    }

    pub fn point(self, name: &str, p: DVec3) -> Self {
        let point = Self::new("point").attribute("name", name);
        self.with(
            point
                .attribute("x", p.x)
                .attribute("y", p.y)
                .attribute("z", p.z),
        )
    }

    /// The transform of the plugin: p' = `matrix` · p.
    pub fn placed(self, matrix: DMat4) -> Self {
        let rows = matrix.transpose().to_cols_array();
        let matrix = Self::new("matrix").attribute("value", spaced(&rows));
        let transform = Self::new("transform").attribute("name", "to_world");
        self.with(transform.with(matrix))
    }

    /// A reference to the plugin with this id.
    pub fn reference(self, id: &str) -> Self {
        self.with(Self::new("ref").attribute("id", id))
    }

    /// The same with the parameter name `name`.
    pub fn named_reference(self, name: &str, id: &str) -> Self {
        let reference = Self::new("ref").attribute("name", name);
        self.with(reference.attribute("id", id))
    }

    /// Writes the document with this element as its root.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        self.element(&mut Writer::new_with_indent(&mut *out, b' ', 2))?;
        out.write_all(b"\n")
    }

    fn element(&self, writer: &mut Writer<&mut dyn Write>) -> io::Result<()> {
        let attributes = (self.attributes.iter()).map(|(name, value)| (*name, value.as_str()));
        let element = writer.create_element(self.tag).with_attributes(attributes);
        if self.children.is_empty() {
            element.write_empty()?;
        } else {
            element.write_inner_content(|writer| {
                self.children
                    .iter()
                    .try_for_each(|child| child.element(writer))
            })?;
        }
        Ok(())
    }
}

fn spaced(numbers: &[f64]) -> String {
    let words: Vec<String> = numbers.iter().map(f64::to_string).collect();
    words.join(" ")
}
