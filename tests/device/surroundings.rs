//! Pictures of the surroundings: how the eye sees them, and how they light surfaces, by closed forms; by all
//! integrators that see them, on the device and by the reference.

use glam::{DQuat, DVec3};
use vkpt::film::Film;
use vkpt::render::{DispatchLimits, Plan, PlanLimits, Target};
use vkpt::settings::{Connect, Integrator, Settings};

use crate::closed_forms::{Case, check, targets};
use crate::common::render::{difference, film, job, on_device_within, outcome, prepared};
use crate::common::surroundings::{background, picture, place, solid_angle, theta};
use crate::common::{self, cpu_driver};

/// Two integrators, and connections with and without weights.
fn settings() -> Vec<(&'static str, Settings)> {
    let mut light = Settings::default();
    light.estimator.connect = Connect::Light;
    let mut both = Settings::default();
    both.estimator.integrator = Integrator::Bidirectional;
    vec![
        ("path", Settings::default()),
        ("path, light", light),
        ("bidirectional", both),
    ]
}

/// The view of a pinhole that looks along −Z of its turned frame: each pixel is the texel in its middle, where it sees one
/// alone.
#[test]
fn the_eye_sees_the_texels_themselves() {
    const SIZE: u32 = 24;
    let colour = |x: u32, y: u32| [x as f32 + 0.5, y as f32 * 0.25, 7.0];
    let picture = picture(8, 4, colour);
    for (words, view, scale, rotate) in [
        ("", "x 90", 1.0, DQuat::IDENTITY),
        ("2", "", 2.0, DQuat::IDENTITY),
        ("z 50 x 20", "z -90 x 80", 1.0, turned(50.0, 20.0)),
    ] {
        let scene = format!(
            "screen {SIZE} {SIZE}\ncamera 3 4 5 1 {view}\n{}sphere 3 4 1e3 1\n",
            background(&picture, words)
        );
        let camera = prepared(&scene, &Settings::default()).camera;
        for target in targets() {
            let film = film(&scene, Settings::default(), 4, 0, &target);
            let mut seen = 0;
            for (i, rgb) in (0..).zip(&film.rgb) {
                let corner = |dx: f64, dy: f64| {
                    let x = 2.0 * (f64::from(i % SIZE) + dx) / f64::from(SIZE) - 1.0;
                    let y = 1.0 - 2.0 * (f64::from(i / SIZE) + dy) / f64::from(SIZE);
                    let d = camera.forward + camera.right * x + camera.up * y;
                    let [u, v] = place(rotate.inverse() * d.normalize());
                    [(u * 8.0) as u32, (v * 4.0) as u32]
                };
                let texel = corner(0.5, 0.5);
                let whole = [(0., 0.), (1., 0.), (0., 1.), (1., 1.)];
                if whole.iter().all(|&(x, y)| corner(x, y) == texel) {
                    let expected = colour(texel[0], texel[1]).map(|c| c * scale as f32);
                    assert_eq!(*rgb, expected, "{target:?}, {words}: pixel {i}");
                    seen += 1;
                }
            }
            assert!(seen > 200, "{seen}");
        }
    }
}

fn turned(z: f64, x: f64) -> DQuat {
    DQuat::from_rotation_z(z.to_radians()) * DQuat::from_rotation_x(x.to_radians())
}

const FLOOR: &str = "brdf .6 .5 .4 0 0 0 1\nbox -50 -50 -1 100 100 1\n";

/// A Lambert plane under one texel: Kd/π L ∫∫ cos θ sin θ dθ dφ = Kd/π L Δφ (sin² θ₁ − sin² θ₀)/2, as of a distant lamp that
/// fills the texel. Weighed, no sample contributes more than its connection and its chance hit: L Kd/π Ω for the largest
/// cosine, and L Kd w with w ≤ (p_b Ω)² where p_b ≤ 1/π.
#[test]
fn one_bright_texel_is_a_distant_lamp() {
    let (mut cases, mut pictures) = (Vec::new(), Vec::new());
    for (width, height, x, y) in [
        (64, 32, 5, 6),
        (512, 256, 300, 40),
        (16, 9, 3, 0),
        (3, 2, 1, 0),
    ] {
        let radiance = 1e5f32;
        let picture = picture(width, height, |i, j| {
            [f32::from((i, j) == (x, y)) * radiance; 3]
        });
        let [upper, lower] = [y, y + 1].map(|edge| theta(edge, height));
        let share = (lower.sin().powi(2) - upper.sin().powi(2)) / f64::from(width);
        let omega = solid_angle(y, width, height);
        for (name, settings) in settings() {
            let scene = format!(
                "screen 24 24\ncamera 0 -3 3 1e-6 x 45\n{}{FLOOR}",
                background(&picture, ".01")
            );
            let expected = [0.6, 0.5, 0.4].map(|kd| kd * 1e3 * share);
            let chance = (omega / std::f64::consts::PI).powi(2);
            cases.push(Case {
                name: format!("{name}: {x},{y} of {width}×{height}"),
                scene,
                settings,
                spp: 16,
                expected,
                most: 0.6 * 1e3 * (omega / std::f64::consts::PI + chance),
                seeds: 1,
            });
        }
        pictures.push(picture);
    }
    check(&cases);
}

/// The same from the side: the picture turned by 90° about x has its texel of the equator above the plane.
#[test]
fn a_turned_picture_lights_from_elsewhere() {
    let picture = picture(64, 33, |x, y| [f32::from((x, y) == (16, 16)); 3]);
    // +Y of the picture, a quarter of its width to the left of the middle, is turned to +Z.
    let cosine = |d: DVec3| (turned(0.0, 90.0) * d).z.max(0.0);
    let steps = 400;
    let cell = |i: i32| (f64::from(i) + 0.5) / f64::from(steps);
    let mut sum = 0.0;
    for (a, b) in (0..steps).flat_map(|i| (0..steps).map(move |j| (cell(i), cell(j)))) {
        let phi = std::f64::consts::TAU * (0.5 - (16.0 + a) / 64.0);
        let [upper, lower] = [16, 17].map(|edge| theta(edge, 33).cos());
        let z = upper + b * (lower - upper);
        let r = (1.0 - z * z).sqrt();
        sum += cosine(DVec3::new(r * phi.cos(), r * phi.sin(), z));
    }
    let irradiance = solid_angle(16, 64, 33) * sum / f64::from(steps * steps);
    let scene = format!(
        "screen 24 24\ncamera 0 -3 3 1e-6 x 45\n{}{FLOOR}",
        background(&picture, "x 90")
    );
    let case = |(name, settings): (&str, Settings)| Case {
        name: name.to_owned(),
        scene: scene.clone(),
        settings,
        spp: 16,
        expected: [0.6, 0.5, 0.4].map(|kd| kd / std::f64::consts::PI * irradiance),
        most: 0.6 * solid_angle(16, 64, 33),
        seeds: 1,
    };
    check(&settings().into_iter().map(case).collect::<Vec<_>>());
}

/// A Lambert plane under a constant picture has the radiance Kd L, and one under a sky that is brighter above, L = 1 where
/// θ < 60° and 1/5 below that, Kd ((sin² 60°) + cos² 60°/5).
#[test]
fn a_sky_in_two_parts_lights_a_plane() {
    let constant = picture(8, 4, |_, _| [2.0, 1.0, 0.5]);
    let parts = picture(12, 6, |_, y| [if y < 2 { 1.0 } else { 0.2 }; 3]);
    let cap = 60f64.to_radians().sin().powi(2);
    let whole = cap + (1.0 - cap) / 5.0;
    let mut cases = Vec::new();
    for (picture, expected, most) in [
        (&constant, [1.2, 0.5, 0.2], 4.0),
        (&parts, [0.6 * whole, 0.5 * whole, 0.4 * whole], 2.0),
    ] {
        for (name, settings) in settings() {
            cases.push(Case {
                name: format!("{name}: {expected:?}"),
                scene: format!(
                    "screen 24 24\ncamera 0 -3 3 1e-6 x 45\n{}{FLOOR}",
                    background(picture, "")
                ),
                settings,
                spp: 64,
                expected,
                most,
                seeds: 1,
            });
        }
    }
    check(&cases);
}

/// Grey surroundings are drawn in proportion to radiance, so a connection contributes Kd cos θ/π times all of it, ∫ L dω,
/// at any texel it found; chance hits weigh in with less than that again. A sun of 1e5 makes no sample that stands out.
#[test]
fn a_sun_makes_no_sample_that_stands_out() {
    let (width, height) = (256, 128);
    let radiance = |x: u32, y: u32| match (x, y) {
        (70, 30) => 1e5f32,
        (_, y) => {
            if y < 64 {
                0.5
            } else {
                0.1
            }
        }
    };
    let sky = picture(width, height, |x, y| [radiance(x, y); 3]);
    let texels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let power: f64 = texels
        .map(|(x, y)| f64::from(radiance(x, y)) * solid_angle(y, width, height))
        .sum();
    let scene = format!(
        "screen 48 48\ncamera 0 -3 3 1e-6 x 45\n{}{FLOOR}",
        background(&sky, "")
    );
    let most = 0.6 * power / std::f64::consts::PI;
    for target in targets() {
        let film: Film = film(&scene, Settings::default(), 1, 5, &target);
        let largest = film.rgb.iter().map(|p| p[0]).fold(0.0, f32::max);
        assert!(
            f64::from(largest) < 2.0 * most,
            "{target:?}: {largest}, {most}"
        );
        // The sun is found by most of the samples.
        let mean = film.rgb.iter().map(|p| f64::from(p[0])).sum::<f64>() / film.rgb.len() as f64;
        assert!(
            f64::from(largest) < 4.0 * mean,
            "{target:?}: {largest}, {mean}"
        );
    }
}

/// A device with small buffers gets the arrays in parts; the picture is the same.
#[test]
fn arrays_in_parts_make_the_same_picture() {
    let sky = picture(64, 32, |x, y| {
        [((x * 5 + y * 3) % 7) as f32, 1.0, y as f32 * 0.1]
    });
    let scene = format!(
        "screen 32 24\ncamera 0 -6 2 .35 x 75\n{}{FLOOR}brdf .2 .2 .2 .5 .5 .5 .1\nsphere 0 0 1 1\n",
        background(&sky, "")
    );
    let settings = Settings::default();
    let prepared = prepared(&scene, &settings);
    let job = job(&prepared, settings, 4, 0);
    // 2048 counts and 6144 values of four bytes.
    for (storage_buffer, expected) in [(1 << 20, (1, 1)), (4096, (2, 6)), (5000, (2, 6))] {
        let limits = PlanLimits {
            storage_buffer,
            ..PlanLimits::default()
        };
        let plan = Plan::new(&job, limits).expect("a plan");
        let names: Vec<_> = plan.scene.iter().map(|array| array.binding.name).collect();
        let parts = |start: &str| names.iter().filter(|name| name.starts_with(start)).count();
        let found = (parts("surroundings_ends"), parts("surroundings_values"));
        assert_eq!(found, expected);
    }
    let Some(device) = common::device() else {
        return;
    };
    let limits = DispatchLimits::of(device).expect("a probe");
    let few = DispatchLimits {
        storage_buffer: 4096,
        ..limits
    };
    let films = [limits, few].map(|limits| on_device_within(&job, limits).expect("a device").film);
    assert_eq!(difference(&films[0], &films[1]), None);
    let reference = outcome(&job, &Target::CpuF32).film;
    if cpu_driver().is_some() {
        assert_eq!(difference(&films[0], &reference), None);
    }
}
