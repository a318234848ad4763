//! What a driver counts of its code.

use std::error::Error;
use std::path::{Path, PathBuf};

use vkpt::gpu::{Device, Options, Selector};
use vkpt::layout::Slice;
use vkpt::prepared::prepare;
use vkpt::render::{Job, KernelChoice, Plan, PlanLimits, Until};
use vkpt::scene;
use vkpt::settings::Settings;

use super::tables;

/// A row a scene and kernel.
pub fn table(scenes: &[PathBuf], device: Option<&str>) -> Result<String, Box<dyn Error>> {
    let options = Options {
        statistics: true,
        ..Options::from_env()
    };
    let selector = device.map_or(Selector::Best, Selector::from);
    let device = Device::open_with(&selector, options)?;
    let mut rows = Vec::new();
    for scene in scenes {
        for kernel in [KernelChoice::Composed, KernelChoice::Full] {
            let name = scene.file_stem().unwrap_or_default().to_string_lossy();
            let counts = counts(&device, scene, kernel)?;
            rows.push(vec![format!("{name}, {kernel:?}").to_lowercase(), counts]);
        }
    }
    let title = format!("What {} counts", device.info().name);
    Ok(tables::table(&title, &["scene, kernel", "counts"], &rows))
}

fn counts(device: &Device, path: &Path, kernel: KernelChoice) -> Result<String, Box<dyn Error>> {
    let settings = Settings::default();
    let read = scene::read(path, false).map_err(|_| format!("{}: no scene", path.display()))?;
    let prepared = prepare(&read.scene, &settings, None)?;
    let job = Job {
        prepared: &prepared,
        settings,
        spp: 1,
        until: Until::default(),
        seed: 0,
        crop: None,
        aovs: &[],
        kernel,
    };
    let plan = Plan::new(&job, PlanLimits::of(device))?;
    let arrays = plan.scene.iter().copied().chain(plan.state.plans());
    let uses: Vec<_> = arrays.map(|a| a.binding.buffer_use).collect();
    let pipeline = device.pipeline(&plan.compile()?[0], &uses, size_of::<Slice>() as u32)?;
    let mut told = pipeline.statistics()?;
    // What only tells one kernel from another.
    told.retain(|s| !s.name.to_lowercase().contains("hash"));
    let told: Vec<String> = told
        .iter()
        .map(|s| format!("{} {}", s.name, s.value))
        .collect();
    Ok(told.join(", "))
}
