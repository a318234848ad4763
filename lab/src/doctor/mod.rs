//! The properties of a device: how it rounds, how accurate its own functions are, whether vkpt's functions equal the
//! reference's, and whether small kernels that drivers have miscompiled give the right results.
//!
//! Every probe is compiled like the rendering kernels, except those that use GLSL's own functions or arithmetic that may
//! be rewritten (`kernel::unaudited`).

mod arguments;
mod arithmetic;
mod bench;
mod builtins;
pub mod command;
mod compare;
mod cost;
mod driver;
mod facts;
mod habits;
mod models;
mod operations;
mod own;
pub mod report;
mod self_tests;

use crate::doctor::report::{Examination, verdict};
use bench::Bench;
use vkpt::gpu::{Device, GpuError};
use vkpt::kernel::OwnFile;

/// The options of an examination.
#[derive(Clone, Copy, Debug, Default)]
pub struct Examiner<'a> {
    /// Checks vkpt's own functions at every `f32` instead of a million: takes minutes.
    pub exhaustive: bool,
    /// Shader files in place of vkpt's, to plant a fault.
    pub own: &'a [OwnFile<'a>],
}

impl Examiner<'_> {
    /// Runs everything on `device`, one piece after the other.
    ///
    /// # Errors
    /// Errors of the device, such as [`GpuError::Lost`], and of kernels that do not compile.
    pub fn examine(&self, device: &Device) -> Result<Examination, GpuError> {
        let bench = Bench {
            device,
            own: self.own,
        };
        let operations = arithmetic::operations(&bench)?;
        let own_functions = own::functions(&bench, &operations, self.exhaustive)?;
        let self_tests = self_tests::self_tests(&bench)?;
        Ok(Examination {
            verdict: verdict(&self_tests, &operations, &own_functions),
            device: facts::facts(device)?,
            watchdog: facts::watchdog(device)?,
            self_tests,
            operations,
            habits: habits::habits(&bench)?,
            own_functions,
            driver_functions: driver::functions(&bench)?,
            costs: cost::costs(&bench)?,
        })
    }
}
