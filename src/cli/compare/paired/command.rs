//! The command line that shows one path.

use crate::cli::job::Request;
use crate::gpu::Selector;
use crate::report::SettingsRecord;
use crate::settings::Settings;

/// `vkpt SCENE …`, to be followed by `--trace X,Y,I`: on the device and cpu-f32, and on both references.
pub fn trace(request: &Request, device: &Selector) -> [String; 2] {
    let mut words = vec![
        "vkpt".to_owned(),
        quoted(&request.scene.display().to_string()),
    ];
    words.extend(request.size.map(|[w, h]| format!("--size {w}x{h}")));
    words.extend((request.seed != 0).then(|| format!("--seed {}", request.seed)));
    words.extend(settings(&request.settings));
    let common = words.join(" ");
    let device = match device {
        Selector::Best => String::new(),
        Selector::Index(i) => format!(" --device {i}"),
        Selector::Name(name) => format!(" --device {}", quoted(name)),
    };
    [
        format!("{common}{device}"),
        format!("{common} --device cpu-f64"),
    ]
}

/// The flags of what is not the default.
fn settings(settings: &Settings) -> Vec<String> {
    let [given, default] = [settings, &Settings::default()].map(SettingsRecord::from);
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
            ("sampler", s.sampler.to_owned()),
        ]
    };
    let pairs = words(given).into_iter().zip(words(default));
    let other = pairs.filter(|(given, default)| given != default);
    other
        .map(|((name, word), _)| format!("--{name} {word}"))
        .collect()
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+=:,".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn what_is_not_the_default_is_in_the_command() {
        let mut settings = Settings::handout();
        settings.model.max_depth = Some(3);
        let mut request = Request {
            scene: Path::new("it's a.txt"),
            settings,
            size: Some([40, 30]),
            crop: Some([1, 2, 3, 4]),
            spp: 9,
            seed: 7,
            strict: true,
        };
        let [device, references] = trace(&request, &Selector::Index(1));
        let common = "vkpt 'it'\\''s a.txt' --size 40x30 --seed 7 --absorption term --radiance-scaling off \
             --max-depth 3 --lobe norms --normals distribution --roulette 0.8";
        assert_eq!(device, format!("{common} --device 1"));
        assert_eq!(references, format!("{common} --device cpu-f64"));
        request = Request {
            scene: Path::new("a/b.txt"),
            settings: Settings::default(),
            size: None,
            seed: 0,
            ..request
        };
        assert_eq!(trace(&request, &Selector::Best)[0], "vkpt a/b.txt");
    }
}
