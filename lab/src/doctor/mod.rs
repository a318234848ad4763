//! The properties of a device: how it rounds, how accurate its own functions are, whether vkpt's functions equal the
//! reference's, whether small kernels that drivers have miscompiled give the right results, and whether pictures of the
//! battery ([`crate::check`]) are within their bounds.
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

use std::sync::atomic::AtomicBool;

use crate::check::{battery, run, select};
use crate::doctor::report::{Battery, Examination, verdict};
use bench::Bench;
use vkpt::gpu::{Device, GpuError};
use vkpt::kernel::OwnFile;
use vkpt::render::KernelChoice;

/// The options of an examination.
#[derive(Clone, Copy)]
pub struct Examiner<'a> {
    /// Checks vkpt's own functions at every `f32` instead of a million: takes minutes.
    pub exhaustive: bool,
    /// Also the driver's choices, its own functions, and costs, which decide nothing.
    pub all: bool,
    /// Names of the battery's cases to render; [`select::SHORT`] except in tests.
    pub cases: &'a [&'a str],
    /// Shader files in place of vkpt's in the probes and self-tests, to plant a fault.
    pub own: &'a [OwnFile<'a>],
    /// The kernels of the battery, composed of vkpt's own files unless a fault is planted.
    pub kernel: KernelChoice<'a>,
    /// Ends the examination; the findings so far stay.
    pub stop: &'a AtomicBool,
}

impl Examiner<'_> {
    /// Runs everything on `device`, one piece after the other, calling `progress` before each with the part that is done
    /// and its name.
    ///
    /// # Errors
    /// Errors of the device, such as [`GpuError::Lost`], and of kernels that do not compile. Errors of the battery's
    /// kernels fail the battery instead.
    pub fn examine(
        &self,
        device: &Device,
        progress: &mut dyn FnMut(f64, &str),
    ) -> Result<Examination, GpuError> {
        let bench = Bench {
            device,
            own: self.own,
            stop: self.stop,
        };
        let pieces = if self.all { 6 } else { 3 } + self.cases.len();
        let mut done = 0;
        let mut next = |name: &str| {
            progress(done as f64 / pieces as f64, name);
            done += 1;
        };
        next("self-tests");
        let self_tests = self_tests::self_tests(&bench)?;
        next("arithmetic");
        let operations = arithmetic::operations(&bench)?;
        next("vkpt's own functions");
        let own_functions = own::functions(&bench, &operations, self.exhaustive)?;
        let (mut habits, mut driver_functions, mut costs) = (None, None, None);
        if self.all {
            next("the driver's habits");
            habits = Some(habits::habits(&bench)?);
            next("GLSL's functions");
            driver_functions = Some(driver::functions(&bench)?);
            next("costs");
            costs = Some(cost::costs(&bench)?);
        }
        let probed = verdict(&self_tests, &operations, &own_functions);
        let battery = self.battery(device, probed.equal_bits, &mut next);
        Ok(Examination {
            verdict: probed.with(&battery, device.info().index),
            device: facts::facts(device)?,
            watchdog: facts::watchdog(device)?,
            self_tests,
            operations,
            own_functions,
            battery,
            habits,
            driver_functions,
            costs,
        })
    }

    /// Renders the cases. Bits are compared with cpu-f32's where all arithmetic is the reference's.
    fn battery(&self, device: &Device, equal_bits: bool, next: &mut dyn FnMut(&str)) -> Battery {
        let all = battery();
        let cases = select::named(&all, self.cases);
        let bench = run::Bench {
            device,
            kernel: self.kernel,
            quick: false,
            correctly_rounded: equal_bits,
            stop: self.stop,
        };
        let of = cases.len();
        let ran = run::run(&all, &cases, &bench, &mut |i, case| {
            next(&format!("case {} of {of}: {}", i + 1, case.name))
        });
        Battery {
            check: ran.record,
            error: ran.error.map(|error| error.to_string()),
        }
    }
}
