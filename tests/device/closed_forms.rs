//! Whole renderings whose radiance is known by hand, on the device and by the reference.
//!
//! Pixels of these pictures all show the same thing, so each is an independent sample of the same mean:
//! Student's t over the pixels, Šidák over each family at α = 1e-3, fixed seeds.

use vkpt::film::Film;
use vkpt::render::Target;
use vkpt::settings::{Absorption, Connect, Roulette, Settings};

use crate::common;
use crate::common::render::{film, prepared};
use crate::common::stats::{mean_and_error, noticeable, p_of_mean, sidak};
use crate::common::table::Table;

const ALPHA: f64 = 1e-3;
/// Rounding of a sum of products in f32, for means that have no variance.
const ROUNDING: f64 = 1e-5;

pub fn targets() -> Vec<Target> {
    let mut targets = vec![Target::CpuF64];
    if common::device().is_some() {
        targets.push(Target::Vulkan(common::selector()));
    }
    targets
}

/// A picture with a known mean.
pub struct Case {
    pub name: String,
    pub scene: String,
    pub settings: Settings,
    pub spp: u32,
    pub expected: Rgb,
    /// The largest contribution of one path: for light that is found in two ways, of both together.
    pub most: f64,
    /// 1: all pixels show the same thing, each is a sample. More: the mean of each seed's picture is a sample.
    pub seeds: u32,
}

pub type Rgb = [f64; 3];

impl Case {
    /// Of all pixels and seeds together.
    fn paths(&self) -> f64 {
        let scene = prepared(&self.scene, &self.settings);
        f64::from(scene.camera.width * scene.camera.height * self.spp * self.seeds)
    }
}

/// Independent samples of each channel.
fn samples(case: &Case, target: &Target) -> [Vec<f64>; 3] {
    let films: Vec<_> = (0..case.seeds)
        .map(|seed| film(&case.scene, case.settings, case.spp, seed, target))
        .collect();
    std::array::from_fn(|c| {
        let pixels = |film: &Film| film.rgb.iter().map(|p| f64::from(p[c])).collect::<Vec<_>>();
        match films.as_slice() {
            [one] => pixels(one),
            many => many.iter().map(|f| mean_and_error(&pixels(f)).0).collect(),
        }
    })
}

/// Every case on every target. Each must fail with its expectation 1 % off, or, where so few paths cannot detect 1 %, by
/// the amount that they can detect.
pub fn check(cases: &[Case]) {
    let level = sidak(ALPHA, 3 * cases.len() * targets().len());
    for target in targets() {
        for case in cases {
            for (samples, expected) in samples(case, &target).iter().zip(case.expected) {
                let p = p_of_mean(samples, expected, ROUNDING * expected);
                let (mean, error) = mean_and_error(samples);
                assert!(
                    p > level,
                    "{} on {target:?}: {mean} ± {error}, expected {expected}, p = {p:e}",
                    case.name
                );
                if expected == 0.0 {
                    continue;
                }
                let paths = case.paths();
                let detectable = noticeable(level, expected, case.most, paths, samples.len());
                let wrong = expected + detectable.max(0.01 * expected);
                let p = p_of_mean(samples, wrong, ROUNDING * expected);
                assert!(
                    p <= level,
                    "{} on {target:?}: {mean} ± {error} passes for {wrong}, p = {p:e}",
                    case.name
                );
            }
        }
    }
}

/// A camera that sees one point: every ray of its 24 × 24 pixels is the same to 1e-6.
fn one_point(eye: &str, orientation: &str) -> String {
    format!("screen 24 24\ncamera {eye} 1e-6 {orientation}\n")
}

/// L = Kd r² / (r² + h²): a disc of radius r and radiance 1 at height h over a Lambert plane (model.md,
/// "Disc of light over a plane").
#[test]
fn disc_light_over_a_lambert_plane() {
    let (r, h, kd) = (0.5, 0.8, 0.7);
    // The camera looks along (0, 1, −1) at the origin; the disc is the lower cap of a thin cylinder.
    let scene = one_point("0 -3 3", "x 45")
        + &format!("brdf {kd} {kd} {kd} 0 0 0 10\nbox -50 -50 -1 100 100 1\n")
        + &format!("light 1 1 1\ncylinder 0 0 {h} 0 0 1e-4 {r}\n");
    let expected = kd * r * r / (r * r + h * h);
    let mut cases = Vec::new();
    for connect in [Connect::Mis, Connect::Light, Connect::Bsdf] {
        for roulette in [Roulette::Throughput, Roulette::Constant(0.8), Roulette::Off] {
            let mut settings = Settings::default();
            settings.estimator.connect = connect;
            settings.estimator.roulette = roulette;
            let name = format!("{connect:?}, {roulette:?}");
            // The disc is nearest right below it: Kd/π · area/h². A light that a path hits contributes Kd, over its survival.
            let survival = match roulette {
                Roulette::Constant(p) => p,
                _ => 1.0,
            };
            let (connected, hit) = (kd * r * r / (h * h), kd / survival);
            let most = match connect {
                Connect::Mis => connected + hit,
                Connect::Light => connected,
                Connect::Bsdf => hit,
            };
            cases.push(Case {
                name,
                scene: scene.clone(),
                settings,
                spp: 64,
                expected: [expected; 3],
                most,
                seeds: 1,
            });
        }
    }
    check(&cases);
}

/// A camera inside glass of index n sees a furnace at n² with radiance scaling, at 1 without (model.md,
/// "Camera in glass"), from inside each of the four shapes. It looks along z, within 36° of it: reflected light meets
/// an end or the ball within the critical angle again and again, so that no path is trapped, and each contributes as much.
#[test]
fn camera_inside_glass_sees_the_furnace_scaled() {
    let glass = "background 1 1 1\nfresnel exact\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\n";
    let cube = common::meshes::cube();
    let shapes = [
        "sphere 0 0 0 1".to_owned(),
        "box -1 -1 -1 2 2 2".to_owned(),
        "cylinder 0 0 -1 0 0 2 1".to_owned(),
        format!("mesh {} 0 0 0 1", cube.path().display()),
    ];
    let mut cases = Vec::new();
    for shape in &shapes {
        for (radiance_scaling, expected) in [(true, 2.25), (false, 1.0)] {
            let mut settings = Settings::default();
            settings.model.radiance_scaling = radiance_scaling;
            cases.push(Case {
                name: format!("{shape}, scaling {radiance_scaling}"),
                scene: format!("screen 16 16\ncamera .1 .2 .3 .5\n{glass}{shape}\n"),
                settings,
                spp: 64,
                expected: [expected; 3],
                most: expected,
                seeds: 1,
            });
        }
    }
    check(&cases);
}

/// Unit sphere of smooth glass (exact Fresnel, n = 1.5) in a unit furnace: means over its disc (model.md,
/// "Sphere in a furnace").
#[test]
fn absorbing_sphere_in_a_furnace() {
    let segment = [
        (1.0, 1.0),
        (0.9, 0.833999),
        (0.5, 0.342929),
        (0.1, 0.106479),
    ];
    let term = [
        (1.0, 1.0),
        (0.9, 0.845640),
        (0.5, 0.359536),
        (0.1, 0.108081),
    ];
    let mut cases = Vec::new();
    for (absorption, means) in [(Absorption::Segment, segment), (Absorption::Term, term)] {
        for (kt, disc) in means {
            let mut settings = Settings::default();
            settings.model.absorption = absorption;
            let glass = format!("fresnel exact\nbrdf 0 0 0 .04 .04 .04 0 {kt} {kt} {kt} 1.5\n");
            // From 1000 away the disc fills the square picture from edge to edge, to 1e-6.
            let scene = "screen 32 32\ncamera 0 0 1000 .001\nbackground 1 1 1\n".to_owned();
            let expected = 1.0 - std::f64::consts::FRAC_PI_4 * (1.0 - disc);
            cases.push(Case {
                name: format!("{absorption:?}, Kt {kt}"),
                scene: scene + &glass + "sphere 0 0 0 1\n",
                settings,
                spp: 16,
                expected: [expected; 3],
                most: 1.0,
                seeds: 24,
            });
        }
    }
    check(&cases);
}

/// A slab of unit thickness: T and R of `slab_beer.csv` (model.md, "Slab with absorption"). Transmitted light is red,
/// reflected light green.
#[test]
fn absorbing_slab() {
    let table = Table::open("slab_beer.csv");
    let mut cases = Vec::new();
    for row in table.rows().step_by(5) {
        let (n, cos, kt) = (row.number("n"), row.number("cos"), row.number("Kt"));
        let degrees = cos.acos().to_degrees();
        let scene = one_point("0 0 3", &format!("x {degrees}"))
            + "light 1 0 0\nbox -1e4 -1e4 -3 2e4 2e4 1\nlight 0 1 0\nbox -1e4 -1e4 4 2e4 2e4 1\n"
            + &format!("fresnel exact\nbrdf 0 0 0 .04 .04 .04 0 {kt} {kt} {kt} {n}\n")
            + "box -1e4 -1e4 0 2e4 2e4 1\n";
        for (absorption, t, r) in [
            (Absorption::Segment, row.number("T"), row.number("R")),
            (
                Absorption::Term,
                row.number("T_handout_EtOnly"),
                row.number("R_handout_EtOnly"),
            ),
        ] {
            let mut settings = Settings::default();
            settings.model.absorption = absorption;
            let name = format!("n {n}, cos {cos}, Kt {kt}, {absorption:?}");
            let scene = scene.clone();
            cases.push(Case {
                name,
                scene,
                settings,
                spp: 64,
                expected: [t, r, 0.0],
                most: 1.0,
                seeds: 1,
            });
        }
    }
    check(&cases);
}
