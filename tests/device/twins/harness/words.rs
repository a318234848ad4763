//! The inputs and outputs of one call, word by word.

use vkpt::reference::math::{Vec3, vec3};

/// The inputs of one call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row(pub Vec<u32>);

impl Row {
    pub fn new() -> Self {
        Self::default()
    }
    pub fn f(mut self, x: f32) -> Self {
        self.0.push(x.to_bits());
        self
    }
    pub fn u(mut self, x: u32) -> Self {
        self.0.push(x);
        self
    }
    pub fn vec2(self, v: [f32; 2]) -> Self {
        self.f(v[0]).f(v[1])
    }
    pub fn vec3(self, v: Vec3<f32>) -> Self {
        self.f(v.x).f(v.y).f(v.z)
    }
}

impl<const N: usize> From<[f32; N]> for Row {
    fn from(values: [f32; N]) -> Self {
        Self(values.map(f32::to_bits).to_vec())
    }
}

/// Bit patterns, as a failure prints them.
impl<const N: usize> From<[u32; N]> for Row {
    fn from(words: [u32; N]) -> Self {
        Self(words.to_vec())
    }
}

/// Reads the inputs of one call, in order.
pub struct In<'a> {
    words: &'a [u32],
    at: usize,
}

impl<'a> In<'a> {
    pub fn new(row: &'a Row) -> Self {
        Self {
            words: &row.0,
            at: 0,
        }
    }
    pub fn u(&mut self) -> u32 {
        self.at += 1;
        self.words[self.at - 1]
    }
    pub fn f(&mut self) -> f32 {
        f32::from_bits(self.u())
    }
    pub fn b(&mut self) -> bool {
        self.u() != 0
    }
    pub fn vec2(&mut self) -> [f32; 2] {
        [self.f(), self.f()]
    }
    pub fn vec3(&mut self) -> Vec3<f32> {
        vec3(self.f(), self.f(), self.f())
    }
}

/// A word written by a function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Float(f32),
    Uint(u32),
}

/// Collects the outputs of one call, in order.
#[derive(Default)]
pub struct Out(pub Vec<Value>);

impl Out {
    pub fn u(&mut self, x: u32) {
        self.0.push(Value::Uint(x));
    }
    pub fn b(&mut self, x: bool) {
        self.u(x.into());
    }
    pub fn f(&mut self, x: f32) {
        self.0.push(Value::Float(x));
    }
    pub fn vec2(&mut self, v: [f32; 2]) {
        v.into_iter().for_each(|x| self.f(x));
    }
    pub fn vec3(&mut self, v: Vec3<f32>) {
        [v.x, v.y, v.z].into_iter().for_each(|x| self.f(x));
    }
}

impl Value {
    /// Of a finite float.
    pub fn magnitude(self) -> f32 {
        match self {
            Self::Float(x) if x.is_finite() => x.abs(),
            _ => 0.0,
        }
    }
}
