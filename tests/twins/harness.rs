//! Holds a GLSL function against its Rust twin, on the device, over a table of inputs.
//!
//! A [`Twin`] is a row of the suite: a body of GLSL that reads its inputs and writes its outputs, a Rust closure that
//! does the same in `f32`, and the inputs: edges first, then seeded ones. Outputs are filled with a NaN pattern
//! beforehand and have guard words around them. On a CPU driver every word must be equal: there `÷` and `√` round
//! correctly as the other operations do. On a GPU they need not, and a last bit may turn a branch: see [`near`].

use std::fmt::Write as _;

use vkpt::gpu::{BufferUse, Device, DeviceKind};
use vkpt::kernel::{Composer, Slot, compile};
use vkpt::reference::math::{Vec3, vec3};

/// What no function writes: a quiet NaN with a payload of its own.
const UNWRITTEN: u32 = 0x7fc0_dead;
/// Before the first row and after each: no function may touch it.
const GUARD: u32 = 0x7fc0_beef;
/// Guard words before the first row.
const MARGIN: usize = 16;
/// Words after the outputs of a row: inputs read, outputs written, a guard.
const TRAILER: usize = 3;

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

impl In<'_> {
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
enum Value {
    Float(f32),
    Uint(u32),
}

/// Collects the outputs of one call, in order.
#[derive(Default)]
pub struct Out(Vec<Value>);

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

/// Seeded inputs: splitmix64, so that rows stay the same for ever.
pub struct Rng(u64);

impl Rng {
    /// The same sequence for the same name.
    fn named(name: &str) -> Self {
        // FNV-1a
        Self(name.bytes().fold(0xcbf2_9ce4_8422_2325, |h, b| {
            (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3)
        }))
    }
    pub fn u32(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) >> 32) as u32
    }
    /// In [0, 1), a multiple of 2⁻²⁴, as the sampler's.
    pub fn unit(&mut self) -> f32 {
        (self.u32() >> 8) as f32 / 16_777_216.0
    }
    pub fn range(&mut self, lo: f32, hi: f32) -> f32 {
        lo + (hi - lo) * self.unit()
    }
    /// Uniform in the logarithm; 0 < lo < hi.
    pub fn log_range(&mut self, lo: f32, hi: f32) -> f32 {
        lo * (hi / lo).powf(self.unit())
    }
    /// Below `n`.
    pub fn below(&mut self, n: u32) -> u32 {
        self.u32() % n
    }
    pub fn bool(&mut self) -> bool {
        self.u32() & 1 == 1
    }
    /// Any finite number, all exponents alike.
    pub fn finite(&mut self) -> f32 {
        loop {
            let x = f32::from_bits(self.u32());
            if x.is_finite() {
                return x;
            }
        }
    }
    /// A unit vector, uniform over the sphere.
    pub fn direction(&mut self) -> Vec3<f32> {
        let z = f64::from(self.range(-1.0, 1.0));
        let phi = f64::from(self.unit()) * std::f64::consts::TAU;
        let r = (1.0 - z * z).max(0.0).sqrt();
        vec3((r * phi.cos()) as f32, (r * phi.sin()) as f32, z as f32)
    }
    /// A unit vector with z > 0.
    pub fn hemisphere(&mut self) -> Vec3<f32> {
        loop {
            let v = self.direction();
            if v.z != 0.0 {
                return vec3(v.x, v.y, v.z.abs());
            }
        }
    }
    /// All components in [lo, hi).
    pub fn vec3(&mut self, lo: f32, hi: f32) -> Vec3<f32> {
        vec3(self.range(lo, hi), self.range(lo, hi), self.range(lo, hi))
    }
}

type Rust = Box<dyn Fn(&mut In, &mut Out)>;

/// A GLSL function and its Rust twin.
///
/// ```ignore
/// Twin::new("to_local", "math/frame")
///     .glsl("Frame f = frame_about(in_vec3()); out_vec3(to_local(f, in_vec3()));")
///     .rust(|i, o| { let f = frame_about(i.vec3()); o.vec3(to_local(f, i.vec3())) })
///     .edge([0.0, 0.0, -1.0, 1.0, 0.0, 0.0])
///     .seeded(1000, |r| Row::new().vec3(r.direction()).vec3(r.direction()))
/// ```
pub struct Twin {
    name: &'static str,
    also: Vec<&'static str>,
    files: Vec<&'static str>,
    composer: Composer,
    glsl: String,
    rust: Option<Rust>,
    rows: Vec<Row>,
}

impl Twin {
    /// The function's name, and the file below `shaders/` that holds it.
    pub fn new(name: &'static str, file: &'static str) -> Self {
        Self {
            name,
            also: Vec::new(),
            files: vec![file],
            composer: Composer::new(),
            glsl: String::new(),
            rust: None,
            rows: Vec::new(),
        }
    }
    /// Other functions that this row holds to account.
    pub fn also(mut self, names: &[&'static str]) -> Self {
        self.also.extend(names);
        self
    }
    /// One more file to compose.
    pub fn file(mut self, file: &'static str) -> Self {
        self.files.push(file);
        self
    }
    /// Text before all files, such as the structs of `layout`.
    pub fn prelude(mut self, text: impl Into<String>) -> Self {
        self.composer = self.composer.prelude(text);
        self
    }
    /// A file that `shaders/` does not hold.
    pub fn source(mut self, name: &str, text: &str) -> Self {
        self.composer = self.composer.add(name, text);
        self
    }
    pub fn slot(mut self, name: &str, slot: Slot) -> Self {
        self.composer = self.composer.slot(name, slot);
        self
    }
    /// Statements that read by `in_f() in_u() in_b() in_vec2() in_vec3()` and write by `out_f(…)` and so on.
    pub fn glsl(mut self, body: &str) -> Self {
        self.glsl = body.to_owned();
        self
    }
    /// The same in Rust.
    pub fn rust(mut self, f: impl Fn(&mut In, &mut Out) + 'static) -> Self {
        self.rust = Some(Box::new(f));
        self
    }
    pub fn edge(mut self, row: impl Into<Row>) -> Self {
        self.rows.push(row.into());
        self
    }
    pub fn edges(mut self, rows: impl IntoIterator<Item = Row>) -> Self {
        self.rows.extend(rows);
        self
    }
    pub fn seeded(mut self, count: usize, mut row: impl FnMut(&mut Rng) -> Row) -> Self {
        let mut rng = Rng::named(self.name);
        self.rows.extend((0..count).map(|_| row(&mut rng)));
        self
    }
    /// The functions that this row holds to account.
    pub fn functions(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(self.name).chain(self.also.iter().copied())
    }
}

/// Checks all twins and panics with all that differ.
pub fn check(twins: &[Twin]) {
    let Some(device) = super::common::device() else {
        return;
    };
    let failures: String = twins
        .iter()
        .filter_map(|t| compare(t, device).err())
        .collect();
    assert!(failures.is_empty(), "{failures}");
    let messages = device.validation_messages();
    assert!(
        messages.is_empty(),
        "the validation layer says: {}",
        messages.join("\n")
    );
}

/// Runs one twin on the device and in Rust; an error tells what differs.
pub fn compare(twin: &Twin, device: &Device) -> Result<(), String> {
    let rust = twin
        .rust
        .as_ref()
        .ok_or_else(|| format!("{}: no Rust\n", twin.name))?;
    let expected: Vec<Vec<Value>> = twin.rows.iter().map(|row| reference(rust, row)).collect();
    let (inputs, outputs) = match (twin.rows.first(), expected.first()) {
        (Some(row), Some(values)) => (row.0.len(), values.len()),
        _ => return Err(format!("{}: no rows\n", twin.name)),
    };
    if twin.rows.iter().any(|r| r.0.len() != inputs) || expected.iter().any(|v| v.len() != outputs)
    {
        return Err(format!("{}: rows of different lengths\n", twin.name));
    }
    let words = run(twin, device, inputs, outputs).map_err(|e| format!("{}: {e}\n", twin.name))?;
    let mut report = Report::new(device.info().kind == DeviceKind::Cpu);
    if words[..MARGIN].iter().any(|w| *w != GUARD) {
        report.broken("wrote before its outputs");
    }
    for (i, (row, values)) in twin.rows.iter().zip(&expected).enumerate() {
        let start = MARGIN + i * (outputs + TRAILER);
        report.row(row, values, &words[start..start + outputs + TRAILER]);
    }
    report.finish(twin.name, twin.rows.len())
}

fn reference(rust: &Rust, row: &Row) -> Vec<Value> {
    let mut out = Out::default();
    rust(
        &mut In {
            words: &row.0,
            at: 0,
        },
        &mut out,
    );
    out.0
}

/// All words of the output buffer.
fn run(
    twin: &Twin,
    device: &Device,
    inputs: usize,
    outputs: usize,
) -> Result<Vec<u32>, Box<dyn std::error::Error>> {
    let kernel = twin
        .composer
        .clone()
        .prelude(frame(inputs, outputs))
        .add("the twin's body", body(&twin.glsl));
    let roots: Vec<&str> = twin
        .files
        .iter()
        .copied()
        .chain(["the twin's body"])
        .collect();
    let kernel = compile(&kernel.compose(&roots)?)?;
    let pipeline = device.pipeline(&kernel, &[BufferUse::Storage; 2], 0)?;

    let rows = twin.rows.len();
    let given: Vec<u32> = std::iter::once(rows as u32)
        .chain(twin.rows.iter().flat_map(|r| r.0.clone()))
        .collect();
    let mut words = vec![GUARD; MARGIN];
    for _ in 0..rows {
        words.extend(std::iter::repeat_n(UNWRITTEN, outputs + TRAILER - 1));
        words.push(GUARD);
    }
    let source = device.buffer("inputs", BufferUse::Storage, given.len() as u64 * 4)?;
    let target = device.buffer("outputs", BufferUse::Storage, words.len() as u64 * 4)?;
    source.write(bytemuck::cast_slice(&given))?;
    target.write(bytemuck::cast_slice(&words))?;
    device.dispatch(
        &pipeline,
        &[&source, &target],
        &[],
        [rows.div_ceil(64) as u32, 1, 1],
    )?;
    target.read_into(bytemuck::cast_slice_mut(&mut words))?;
    Ok(words)
}

/// Buffers and the functions that read and write them.
fn frame(inputs: usize, outputs: usize) -> String {
    let stride = outputs + TRAILER;
    format!(
        "layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer TwinIn {{ uint words[]; }} twin_in;
layout(std430, set = 0, binding = 1) buffer TwinOut {{ uint words[]; }} twin_out;
const uint TWIN_INPUTS = {inputs}u;
const uint TWIN_OUTPUTS = {outputs}u;
const uint TWIN_STRIDE = {stride}u;
const uint TWIN_MARGIN = {MARGIN}u;
uint twin_in_at;
uint twin_out_at;
uint in_u() {{ twin_in_at += 1u; return twin_in.words[twin_in_at - 1u]; }}
float in_f() {{ return uintBitsToFloat(in_u()); }}
bool in_b() {{ return in_u() != 0u; }}
vec2 in_vec2() {{ float x = in_f(); float y = in_f(); return vec2(x, y); }}
vec3 in_vec3() {{ float x = in_f(); float y = in_f(); float z = in_f(); return vec3(x, y, z); }}
void out_u(uint x) {{ twin_out.words[twin_out_at] = x; twin_out_at += 1u; }}
void out_f(float x) {{ out_u(floatBitsToUint(x)); }}
void out_b(bool x) {{ out_u(x ? 1u : 0u); }}
void out_vec2(vec2 v) {{ out_f(v.x); out_f(v.y); }}
void out_vec3(vec3 v) {{ out_f(v.x); out_f(v.y); out_f(v.z); }}
"
    )
}

fn body(statements: &str) -> String {
    format!(
        "void main() {{
    uint row = gl_GlobalInvocationID.x;
    if (row < twin_in.words[0]) {{
        twin_in_at = 1u + row * TWIN_INPUTS;
        twin_out_at = TWIN_MARGIN + row * TWIN_STRIDE;
{statements}
        uint end = TWIN_MARGIN + row * TWIN_STRIDE + TWIN_OUTPUTS;
        twin_out.words[end] = twin_in_at - 1u - row * TWIN_INPUTS;
        twin_out.words[end + 1u] = twin_out_at + TWIN_OUTPUTS - end;
    }}
}}
"
    )
}

/// What differs, for one twin.
struct Report {
    exact: bool,
    text: String,
    differing: usize,
    broken: bool,
}

/// Rows that a report shows.
const SHOWN: usize = 5;

impl Report {
    fn new(exact: bool) -> Self {
        Self {
            exact,
            text: String::new(),
            differing: 0,
            broken: false,
        }
    }

    /// What no device may do.
    fn broken(&mut self, what: &str) {
        self.broken = true;
        let _ = writeln!(self.text, "  {what}");
    }

    /// `words`: outputs and trailer.
    fn row(&mut self, row: &Row, values: &[Value], words: &[u32]) {
        let (words, trailer) = words.split_at(values.len());
        let mut lines = String::new();
        if trailer != [row.0.len() as u32, values.len() as u32, GUARD] {
            let [read, written, guard] = [trailer[0], trailer[1], trailer[2]];
            self.broken = true;
            let _ = writeln!(
                lines,
                "    the kernel read {read} words and wrote {written}, Rust {} and {}; guard {guard:#010x}",
                row.0.len(),
                values.len()
            );
        }
        let scale = values.iter().map(|v| v.magnitude()).fold(0.0, f32::max);
        for (i, (value, word)) in values.iter().zip(words).enumerate() {
            let same = if self.exact {
                equal(*value, *word)
            } else {
                near(*value, *word, scale)
            };
            if !same {
                let _ = writeln!(lines, "    output {i}: {}", difference(*value, *word));
            }
        }
        if !lines.is_empty() {
            self.differing += 1;
            if self.differing <= SHOWN {
                let _ = write!(self.text, "  .edge([{}])\n{lines}", row_text(row));
            }
        }
    }

    fn finish(self, name: &str, rows: usize) -> Result<(), String> {
        // Not exact: a comparison on the brink may turn out otherwise, rarely.
        let allowed = if self.exact { 0 } else { rows / 100 };
        if self.broken || self.differing > allowed {
            return Err(format!(
                "{name}: {} of {rows} rows differ\n{}",
                self.differing, self.text
            ));
        }
        Ok(())
    }
}

impl Value {
    fn magnitude(self) -> f32 {
        match self {
            Self::Float(x) if x.is_finite() => x.abs(),
            _ => 0.0,
        }
    }
}

/// The same bits; a NaN equals any NaN that was written.
fn equal(value: Value, word: u32) -> bool {
    match value {
        Value::Uint(x) => x == word,
        Value::Float(x) if x.is_nan() => f32::from_bits(word).is_nan() && word != UNWRITTEN,
        Value::Float(x) => x.to_bits() == word,
    }
}

/// On devices that may round `÷` and `√` their own way: integers equal; floats within 1e-4 of their size, or within 1e-5 of
/// the row's largest output, which a difference of large numbers may lose. One row in a hundred may lie elsewhere.
fn near(value: Value, word: u32, scale: f32) -> bool {
    match value {
        Value::Float(x) if x.is_finite() => {
            let difference = (x - f32::from_bits(word)).abs();
            difference <= 1e-4 * x.abs() || difference <= 1e-5 * scale
        }
        value => equal(value, word),
    }
}

fn difference(value: Value, word: u32) -> String {
    match value {
        _ if word == UNWRITTEN => "not written".into(),
        Value::Uint(x) => format!("device {word:#010x} ({word}), Rust {x:#010x} ({x})"),
        Value::Float(x) => {
            let (bits, y) = (x.to_bits(), f32::from_bits(word));
            let ulps = (order(bits) - order(word)).abs();
            format!("device {word:#010x} ({y:e}), Rust {bits:#010x} ({x:e}), {ulps} ulps apart")
        }
    }
}

/// Neighbouring floats have neighbouring numbers.
fn order(bits: u32) -> i64 {
    let magnitude = i64::from(bits & 0x7fff_ffff);
    if bits >> 31 == 1 {
        -magnitude - 1
    } else {
        magnitude
    }
}

fn row_text(row: &Row) -> String {
    let word = |w: &u32| format!("{w:#010x} /* {:e} */", f32::from_bits(*w));
    let words: Vec<String> = row.0.iter().map(word).collect();
    words.join(", ")
}
