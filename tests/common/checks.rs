//! Records of `vkpt check` that never ran, and pictures to show next to them.

use vkpt::film::Film;
use vkpt::metrics::difference_map;
use vkpt::report::SettingsRecord;
use vkpt::settings::Settings;
use vkpt_lab::check::report::{CaseRecord, Check, Held, Shown};

/// A case that is compared with `held`.
pub fn case(name: &str, held: Vec<Held>) -> CaseRecord {
    CaseRecord {
        name: name.to_owned(),
        about: "something stiff".to_owned(),
        samples: 1_048_576,
        diverged: 1234,
        median: Some(0.0),
        p99: Some(1.25e-7),
        worst: Some(1.0),
        worst_at: Some([1, 2, 3]),
        diverged_at: None,
        nan: 0,
        infinite: 0,
        largest: 2.25,
        mean: 0.834_567,
        standard_error: 1e-4,
        expected: None,
        seconds: 0.25,
        warnings: Vec::new(),
        margin: held.iter().map(|h| h.margin).fold(0.0, f64::max),
        passed: held.iter().all(Held::passed),
        held,
    }
}

/// Two cases, of which the second fails twice.
pub fn run() -> Check {
    let good = vec![
        Held::new("energy", 0.5, 1.0, "chance"),
        Held::new("NaN", 0.0, 0.0, "none"),
    ];
    let bad = vec![
        Held::new("weight", 4.5, 1.0, "no path may contribute more"),
        Held::new("NaN", 2.0, 0.0, "none"),
    ];
    let cases = vec![
        case("alpha/ggx/1e-3", good),
        case("furnace/rough-cylinder/2^-17", bad),
    ];
    check(cases)
}

/// A run on a CPU driver.
pub fn check(cases: Vec<CaseRecord>) -> Check {
    Check {
        version: "0.0.0",
        device: "a device".to_owned(),
        driver: "its driver".to_owned(),
        correctly_rounded: true,
        quick: false,
        level: 1e-6,
        alpha: 1e-3,
        seconds: 61.0,
        interrupted: false,
        passed: cases.iter().all(|c| c.passed),
        cases,
    }
}

/// Where [`shown`] has a difference, and which.
pub const PLANTED: ([usize; 2], f64) = ([5, 3], -1e-3);

/// Pictures of 16 × 16 pixels that differ in one.
pub fn shown() -> Shown {
    let [x, y] = PLANTED.0;
    let mut differences = [0.0; 256];
    differences[16 * y + x] = PLANTED.1;
    let film = |scale: f32| Film {
        width: 16,
        height: 16,
        rgb: (0..256u16)
            .map(|k| [scale * f32::from(k), 0.5, 0.25])
            .collect(),
    };
    Shown {
        scene: "screen 16 16\ncamera 0 0 1 1\n".to_owned(),
        triangles: None,
        settings: SettingsRecord::from(&Settings::default()),
        spp: 16,
        seed: 1,
        crop: None,
        device: film(1.0 / 256.0),
        reference: film(1.0 / 256.0),
        difference: difference_map(16, 16, &differences),
    }
}
