//! Command lines: the one that was typed, and those that trace one path.

use std::ffi::OsString;
use std::ops::Range;
use std::sync::OnceLock;

use super::job::Request;
use vkpt::gpu::Selector;
use vkpt::render::Target;
use vkpt::report::names::Named;
use vkpt::report::{Job, SettingsRecord};
use vkpt::settings::Settings;
use vkpt::shell::{self, quoted};

static TYPED: OnceLock<Vec<OsString>> = OnceLock::new();

/// Stores the words that were typed; a process has one command line, the first that it runs.
pub fn keep(words: impl Iterator<Item = OsString>) -> &'static [OsString] {
    TYPED.get_or_init(|| words.collect())
}

/// The command line that was typed, as a shell takes it.
pub fn typed() -> String {
    let words = TYPED.get().into_iter().flatten();
    shell::line(words.map(|word| word.to_string_lossy().into_owned()))
}

/// `vkpt SCENE …` with everything that a path depends on; the caller appends `--trace X,Y,I`.
pub fn show(request: &Request, target: &Target) -> String {
    let mut words = vec!["vkpt".to_owned(), quoted(&request.scene.word())];
    words.extend(request.camera.map(camera));
    words.extend(request.size.map(|[w, h]| format!("--size {w}x{h}")));
    words.extend((request.seed != 0).then(|| format!("--seed {}", request.seed)));
    words.extend(settings(&SettingsRecord::from(&request.settings)));
    let integrator = request.settings.estimator.integrator.name();
    words.extend((!request.auto).then(|| format!("--integrator {integrator}")));
    let device = match target {
        Target::Vulkan(Selector::Best) => None,
        Target::Vulkan(Selector::Index(i)) => Some(i.to_string()),
        Target::Vulkan(Selector::Name(name)) => Some(quoted(name)),
        Target::CpuF32 => Some("cpu-f32".to_owned()),
        Target::CpuF64 => Some("cpu-f64".to_owned()),
    };
    words.extend(device.map(|device| format!("--device {device}")));
    words.join(" ")
}

/// `vkpt SCENE --samples A..B …` with everything that the samples of a job depend on, except the device.
pub fn rendering(job: &Job, samples: Range<u32>) -> String {
    let mut words = vec!["vkpt".to_owned(), quoted(&job.scene)];
    words.push(format!("--samples {}..{}", samples.start, samples.end));
    words.extend(job.camera.as_deref().map(camera));
    words.push(format!("--size {}x{}", job.size[0], job.size[1]));
    words.extend(
        job.crop
            .map(|[x0, y0, x1, y1]| format!("--crop {x0},{y0},{x1},{y1}")),
    );
    words.extend((job.seed != 0).then(|| format!("--seed {}", job.seed)));
    words.extend(settings(&job.settings));
    words.push(format!("--integrator {}", job.settings.integrator));
    words.join(" ")
}

/// The same, with the name of a file to write.
pub fn part(job: &Job, samples: Range<u32>) -> String {
    let file = format!("{}-{}.vkpt", samples.start, samples.end);
    format!("{} -o {file}", rendering(job, samples))
}

/// The flag that chooses a camera.
fn camera(name: &str) -> String {
    format!("--camera={}", quoted(name))
}

/// The flags of all settings that are not the default.
fn settings(given: &SettingsRecord) -> Vec<String> {
    let default = SettingsRecord::from(&Settings::default());
    let switch = |on| if on { "on" } else { "off" }.to_owned();
    let depth = |depth: Option<u32>| depth.map_or(String::new(), |n| n.to_string());
    let words = |s: SettingsRecord| {
        [
            ("fresnel", s.fresnel.to_owned()),
            ("distribution", s.distribution.to_owned()),
            ("absorption", s.absorption.to_owned()),
            ("radiance-scaling", switch(s.radiance_scaling)),
            ("max-depth", depth(s.max_depth)),
            ("lobe", s.lobe.to_owned()),
            ("normals", s.normals.to_owned()),
            ("roulette", s.roulette),
            ("connect", s.connect.to_owned()),
            ("lights", s.lights.to_owned()),
            ("sampler", s.sampler.to_owned()),
        ]
    };
    let pairs = words(given.clone()).into_iter().zip(words(default));
    let other = pairs.filter(|(given, default)| given != default);
    other
        .map(|((name, word), _)| format!("--{name} {word}"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::source::Source;

    #[test]
    fn the_command_has_every_value_that_is_not_the_default() {
        let mut settings = Settings::handout();
        settings.model.max_depth = Some(3);
        let scene = Source::File("it's a.txt".into());
        let mut request = Request {
            scene: &scene,
            settings,
            auto: false,
            camera: Some("it's"),
            size: Some([40, 30]),
            crop: Some([1, 2, 3, 4]),
            spp: 9,
            seed: 7,
            strict: true,
            quiet: false,
        };
        let device = show(&request, &Target::Vulkan(Selector::Index(1)));
        let references = show(&request, &Target::CpuF64);
        let common = "vkpt 'it'\\''s a.txt' --camera='it'\\''s' --size 40x30 --seed 7 --absorption term --radiance-scaling off \
             --max-depth 3 --lobe norms --normals distribution --roulette 0.8 --lights power --sampler random --integrator path";
        assert_eq!(device, format!("{common} --device 1"));
        assert_eq!(references, format!("{common} --device cpu-f64"));
        request = Request {
            scene: &Source::Stdin,
            settings: Settings::default(),
            auto: true,
            camera: None,
            size: None,
            seed: 0,
            ..request
        };
        let best = Target::Vulkan(Selector::Best);
        assert_eq!(show(&request, &best), "vkpt -");
    }
}
