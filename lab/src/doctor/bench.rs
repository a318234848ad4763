//! Small kernels, run on the examined device.

use std::sync::atomic::{AtomicBool, Ordering};

use vkpt::gpu::{Buffer, BufferUse, Device, GpuError, Pipeline};
use vkpt::kernel::{Composer, OwnFile, Slot, Spirv, compile, unaudited};
use vkpt::layout::constants::workgroup::WORKGROUP;

/// The device on the bench.
pub struct Bench<'a> {
    pub device: &'a Device,
    /// Shader files in place of vkpt's.
    pub own: &'a [OwnFile<'a>],
    pub stop: &'a AtomicBool,
}

/// The function that a kernel calls on each row of its arguments.
#[derive(Clone, Debug)]
pub struct Subject {
    glsl: String,
    compiled: Compiled,
}

/// How a kernel is compiled.
#[derive(Clone, Copy, Debug)]
enum Compiled {
    /// Like those that render.
    Audited,
    /// With GLSL's own functions.
    Unaudited(unaudited::Arithmetic),
}

impl Subject {
    /// A float as an expression of the floats x, y and z, whose bits the arguments are.
    pub fn float(uses: &str, expression: &str) -> Self {
        let floats = "float x = uintBitsToFloat(w.x); float y = uintBitsToFloat(w.y); float z = uintBitsToFloat(w.z);";
        let glsl = format!(
            "// uses: {uses}\nuint subject(uvec3 w) {{ {floats} return floatBitsToUint({expression}); }}\n"
        );
        Self::new(glsl)
    }

    /// A word as an expression of the vector of words w.
    pub fn word(expression: &str) -> Self {
        Self::new(format!(
            "uint subject(uvec3 w) {{ return {expression}; }}\n"
        ))
    }

    fn new(glsl: String) -> Self {
        Self {
            glsl,
            compiled: Compiled::Audited,
        }
    }

    /// The same, allowed to call GLSL's own functions.
    pub fn unaudited(mut self, arithmetic: unaudited::Arithmetic) -> Self {
        self.compiled = Compiled::Unaudited(arithmetic);
        self
    }
}

impl<'a> Bench<'a> {
    /// Whether the examination is to end.
    pub fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn composer(&self) -> Composer {
        let add = |composer: Composer, file: &OwnFile| composer.add(file.name, file.text);
        self.own.iter().fold(Composer::new(), add)
    }

    /// A file of `shaders/`, compiled like those that render.
    pub fn file(&self, name: &str) -> Result<Spirv, GpuError> {
        Ok(compile(&self.composer().compose(&[name])?)?)
    }

    /// A file that does things that no rendering kernel does.
    pub fn unaudited_file(&self, name: &str) -> Result<Spirv, GpuError> {
        let kernel = self.composer().compose(&[name])?;
        Ok(unaudited::compile(
            &kernel,
            unaudited::Arithmetic::AsWritten,
        )?)
    }

    /// A file of `shaders/` with a subject to call.
    pub fn with(&self, name: &str, subject: &Subject) -> Result<Spirv, GpuError> {
        let slot = Slot::Text(subject.glsl.clone());
        let kernel = self.composer().slot("subject", slot).compose(&[name])?;
        Ok(match subject.compiled {
            Compiled::Audited => compile(&kernel)?,
            Compiled::Unaudited(arithmetic) => unaudited::compile(&kernel, arithmetic)?,
        })
    }

    /// A subject prepared for tables of up to `rows` rows.
    pub fn caller(&self, subject: &Subject, rows: usize) -> Result<Caller<'a>, GpuError> {
        Caller::new(
            self.device,
            &self.with("doctor/subject.comp", subject)?,
            rows,
        )
    }

    /// A subject's results for a table.
    pub fn call(&self, subject: &Subject, table: &[[u32; 3]]) -> Result<Vec<u32>, GpuError> {
        self.caller(subject, table.len())?.call(table)
    }
}

/// A kernel that maps each row of three words to a word, with its buffers.
pub struct Caller<'a> {
    device: &'a Device,
    pipeline: Pipeline,
    arguments: Buffer,
    results: Buffer,
}

impl<'a> Caller<'a> {
    pub fn new(device: &'a Device, kernel: &Spirv, rows: usize) -> Result<Self, GpuError> {
        let words = rows.next_multiple_of(WORKGROUP as usize) as u64;
        let storage = BufferUse::Storage;
        Ok(Self {
            device,
            pipeline: device.pipeline(kernel, &[storage; 2], 0)?,
            arguments: device.buffer("arguments", storage, 12 * words)?,
            results: device.buffer("results", storage, 4 * words)?,
        })
    }

    /// One result for each row.
    pub fn call(&self, table: &[[u32; 3]]) -> Result<Vec<u32>, GpuError> {
        self.arguments.write(bytemuck::cast_slice(table))?;
        let buffers = [&self.arguments, &self.results];
        let groups = (table.len() as u32).div_ceil(WORKGROUP);
        self.device
            .dispatch(&self.pipeline, &buffers, &[], [groups, 1, 1])?;
        let mut results = vec![0u32; table.len()];
        self.results
            .read_into(bytemuck::cast_slice_mut(&mut results))?;
        Ok(results)
    }
}
