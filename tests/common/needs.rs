//! Requirements of tests outside this repository: a device, drivers, programs.
//!
//! A test fails where one is missing, and says what to install. A run may go without it, and says so outright by an
//! environment variable: the tests that need it then return early, each with one line that `.ci/run` counts,
//! `skipped: NAME: WHY`.

use std::fmt::Display;
use std::fs;
use std::io::Write as _;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// A Vulkan device.
    Device,
    /// A device that rounds as `cpu-f32` does, which drivers for CPUs do.
    CpuDriver,
    /// Mesa's driver for CPUs.
    Lavapipe,
    /// Mesa's driver for AMD's GPUs, which compiles without one.
    Radv,
    /// Khronos' validation layer.
    Validation,
    /// `spirv-val` and `spirv-dis`.
    SpirvTools,
    Chromium,
    /// Headers that layers of Vulkan are compiled against.
    VulkanHeaders,
    /// Disks of the test's own: user namespaces that may mount.
    Mounts,
    /// `slurmctld`, `slurmd`, `munged` and the commands of Slurm.
    Slurm,
    Shellcheck,
    /// GNU parallel.
    Parallel,
    /// Python's `distributed`.
    Dask,
}

impl Need {
    /// The variable that, when it is 1, makes the run go without.
    fn variable(self) -> &'static str {
        match self {
            Self::Device => "VKPT_TEST_NO_GPU",
            Self::CpuDriver => "VKPT_TEST_NO_CPU_DRIVER",
            Self::Lavapipe => "VKPT_TEST_NO_LAVAPIPE",
            Self::Radv => "VKPT_TEST_NO_RADV",
            Self::Validation => "VKPT_TEST_NO_VALIDATION",
            Self::SpirvTools => "VKPT_TEST_NO_SPIRV_TOOLS",
            Self::Chromium => "VKPT_TEST_NO_CHROMIUM",
            Self::VulkanHeaders => "VKPT_TEST_NO_VULKAN_HEADERS",
            Self::Mounts => "VKPT_TEST_NO_MOUNTS",
            Self::Slurm => "VKPT_TEST_NO_SLURM",
            Self::Shellcheck => "VKPT_TEST_NO_SHELLCHECK",
            Self::Parallel => "VKPT_TEST_NO_PARALLEL",
            Self::Dask => "VKPT_TEST_NO_DASK",
        }
    }

    /// Debian's name for it.
    fn package(self) -> &'static str {
        match self {
            Self::Device | Self::CpuDriver | Self::Lavapipe | Self::Radv => "mesa-vulkan-drivers",
            Self::Validation => "vulkan-validationlayers",
            Self::SpirvTools => "spirv-tools",
            Self::Chromium => "chromium",
            Self::VulkanHeaders => "libvulkan-dev",
            Self::Mounts => "util-linux",
            Self::Slurm => "slurm-wlm munge",
            Self::Shellcheck => "shellcheck",
            Self::Parallel => "parallel",
            Self::Dask => "python3-distributed",
        }
    }

    /// Whether the run skips it.
    pub fn waived(self) -> bool {
        std::env::var_os(self.variable()).is_some_and(|v| v == "1")
    }

    /// A requirement of the test; `None`, with a line that says so, if the run skips it.
    ///
    /// # Panics
    /// Where it is missing.
    pub fn find<T, E: Display>(self, find: impl FnOnce() -> Result<T, E>) -> Option<T> {
        if self.skips() {
            return None;
        }
        Some(find().unwrap_or_else(|missing| self.fail(missing)))
    }

    /// Whether the run skips it, and so the test is skipped, which is printed.
    pub fn skips(self) -> bool {
        if self.waived() {
            skipped(&format!("{}=1", self.variable()));
        }
        self.waived()
    }

    /// It is missing: prints the error, and what to do.
    pub fn fail(self, missing: impl Display) -> ! {
        panic!(
            "{missing}\nDebian: apt-get install {}\n{}=1 skips the tests that need it",
            self.package(),
            self.variable()
        )
    }
}

/// radv's manifest for the loader; `None` if the run skips it.
pub fn radv() -> Option<String> {
    Need::Radv.find(|| {
        let folder = "/usr/share/vulkan/icd.d";
        let manifests = fs::read_dir(folder).map_err(|e| format!("{folder}: {e}"))?;
        manifests
            .flatten()
            .map(|entry| entry.path().display().to_string())
            .find(|path| path.contains("radeon_icd"))
            .ok_or(format!("Mesa's radv is not in {folder}"))
    })
}

/// Says that the running test is skipped; libtest names its thread. Written past libtest, which shows nothing that a
/// test prints and passes.
fn skipped(why: &str) {
    let thread = std::thread::current();
    let test = thread.name().unwrap_or("a test");
    let line = format!("skipped: {test}: {why}\n");
    std::io::stderr()
        .write_all(line.as_bytes())
        .expect("standard error");
}
