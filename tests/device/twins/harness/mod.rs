//! Compares a GLSL function with its Rust twin, on the device, over a table of inputs.
//!
//! A [`Twin`] is a row of the suite: a body of GLSL that reads its inputs and writes its outputs, a Rust closure that
//! does the same in `f32`, and the inputs: edges first, then seeded ones. Outputs are filled with a NaN pattern
//! beforehand and have guard words around them. On a CPU driver every word must be equal: there `÷` and `√` round
//! correctly as the other operations do. On a GPU they need not, and a last bit may turn a branch: see `report::near`.

mod report;
mod rng;
mod words;

use vkpt::gpu::{BufferUse, Device, DeviceKind};
use vkpt::kernel::{Composed, Composer, KernelError, Slot, compile};

use report::Report;
pub use rng::Rng;
use words::Value;
pub use words::{In, Out, Row};

/// A value that no function writes: a quiet NaN with its own payload.
const UNWRITTEN: u32 = 0x7fc0_dead;
/// Before the first row and after each: no function may touch it.
const GUARD: u32 = 0x7fc0_beef;
/// Guard words before the first row.
const MARGIN: usize = 16;
/// Words after the outputs of a row: inputs read, outputs written, a guard.
const TRAILER: usize = 3;

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
    /// The function's name, and the file below `shaders/` that contains it.
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
    /// Other functions that this row tests.
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
    /// A file that is not in `shaders/`.
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
    /// (file, function) for each function that this row tests: those named, in each file of its kernel,
    /// because functions of one name may be in several files for one slot.
    pub fn tested(&self) -> Vec<(String, &'static str)> {
        let kernel = self
            .kernel(0, 0)
            .unwrap_or_else(|e| panic!("{}: {e}", self.name));
        let names = || std::iter::once(self.name).chain(self.also.iter().copied());
        kernel
            .files()
            .flat_map(|file| names().map(move |name| (file.to_owned(), name)))
            .collect()
    }

    fn kernel(&self, inputs: usize, outputs: usize) -> Result<Composed, KernelError> {
        let composer = self
            .composer
            .clone()
            .prelude(frame(inputs, outputs))
            .add(BODY, body(&self.glsl));
        let roots: Vec<&str> = self.files.iter().copied().chain([BODY]).collect();
        composer.compose(&roots)
    }
}

/// The file that calls the function.
const BODY: &str = "the twin's body";

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

/// Runs one twin on the device and in Rust; an error reports the differences.
pub fn compare(twin: &Twin, device: &Device) -> Result<(), String> {
    let rust = twin
        .rust
        .as_ref()
        .ok_or_else(|| format!("{}: no Rust\n", twin.name))?;
    let expected: Vec<Vec<Value>> = twin.rows.iter().map(|row| call(rust, row)).collect();
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

/// Rust's results for a row.
fn call(rust: &Rust, row: &Row) -> Vec<Value> {
    let mut out = Out::default();
    rust(&mut In::new(row), &mut out);
    out.0
}

/// All words of the output buffer.
fn run(
    twin: &Twin,
    device: &Device,
    inputs: usize,
    outputs: usize,
) -> Result<Vec<u32>, Box<dyn std::error::Error>> {
    let kernel = compile(&twin.kernel(inputs, outputs)?)?;
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
