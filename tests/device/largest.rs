//! The largest sample in the film, against all samples traced one by one: of every integrator, in a crop, with any
//! tiles and dispatches.

use vkpt::prepared::Prepared;
use vkpt::reference::integrator::bidirectional::record;
use vkpt::reference::integrator::bidirectional::{Transport, Ways, trace_bidirectional};
use vkpt::reference::integrator::light;
use vkpt::reference::integrator::light::splat::Window;
use vkpt::reference::integrator::light::{Splat, trace_light};
use vkpt::reference::integrator::path::record::Silent;
use vkpt::reference::integrator::path::trace_path;
use vkpt::reference::path::SampleId;
use vkpt::reference::world::World;
use vkpt::render::{DISPATCH_TIME, DispatchLimits, Job, Outcome, Target};
use vkpt::sample::{Address, Largest};
use vkpt::settings::{Integrator, Settings};

use crate::common::cpu_driver;
use crate::common::render::{job, on_device, on_device_within, outcome, prepared};
use crate::common::scenes::{SMOOTH, TABLE, WIDE};

const SIZE: [u32; 2] = [32, 24];
const SPP: u32 = 6;
const SEED: u32 = 5;
const CROP: [u32; 4] = [5, 3, 22, 20];

fn by(integrator: Integrator) -> Settings {
    let mut settings = Settings::default();
    settings.estimator.integrator = integrator;
    settings
}

fn id([column, row]: [u32; 2], sample: u32) -> SampleId {
    SampleId {
        column,
        row,
        pixel: row * SIZE[0] + column,
        sample,
        seed: SEED,
    }
}

fn pixels([left, top, right, bottom]: [u32; 4]) -> impl Iterator<Item = [u32; 2]> {
    (top..bottom).flat_map(move |y| (left..right).map(move |x| [x, y]))
}

/// Each sample of the crop: where it is, and its brightest channel.
fn samples(scene: &Prepared, settings: &Settings) -> Vec<Largest> {
    let world = World::<f32>::new(scene);
    let mut all = Vec::new();
    for sample in 0..SPP {
        let mut radiance = vec![[0f64; 3]; (SIZE[0] * SIZE[1]) as usize];
        match settings.estimator.integrator {
            Integrator::Path => {
                for pixel in pixels(CROP) {
                    let id = id(pixel, sample);
                    let path = trace_path(&world, settings, id, &mut Silent);
                    radiance[id.pixel as usize] = path.radiance.f64().to_array();
                }
            }
            Integrator::Light | Integrator::Bidirectional => {
                let window = Window {
                    x: 0,
                    y: 0,
                    width: SIZE[0],
                    height: SIZE[1],
                };
                let adjoint = settings.adjoint();
                let transport = Transport {
                    world: &world,
                    settings,
                    adjoint: &adjoint,
                    ways: Ways::All,
                };
                let mut take = |splat: Splat<f32>| {
                    let sum = &mut radiance[splat.pixel as usize];
                    let value = splat.value.f64().to_array();
                    *sum = [0, 1, 2].map(|c| sum[c] + value[c]);
                };
                for pixel in pixels([0, 0, SIZE[0], SIZE[1]]) {
                    let id = id(pixel, sample);
                    match settings.estimator.integrator {
                        Integrator::Bidirectional => {
                            let (seen, _) = trace_bidirectional(
                                transport,
                                window,
                                id,
                                &mut record::Silent,
                                &mut take,
                            );
                            let pixel = id.pixel;
                            seen.into_iter()
                                .for_each(|value| take(Splat { value, pixel }));
                        }
                        _ => {
                            trace_light(
                                &world,
                                &adjoint,
                                window,
                                id,
                                &mut light::record::Silent,
                                &mut take,
                            );
                        }
                    }
                }
            }
        }
        all.extend(pixels(CROP).map(|pixel| {
            Largest {
                address: Address {
                    pixel,
                    index: sample,
                },
                radiance: radiance[id(pixel, sample).pixel as usize]
                    .into_iter()
                    .fold(0.0, f64::max),
            }
        }));
    }
    all
}

/// Of equals the first by row, column and index.
fn largest(samples: impl Iterator<Item = Largest>) -> Option<Largest> {
    let place = |l: &Largest| (l.address.pixel[1], l.address.pixel[0], l.address.index);
    let order = |a: &Largest, b: &Largest| {
        (a.radiance.total_cmp(&b.radiance)).then(place(b).cmp(&place(a)))
    };
    samples.max_by(order)
}

/// Sums of splats in f64 are within 2⁻²⁰ of those of the film.
fn agree(found: Option<Largest>, expected: Option<Largest>) -> bool {
    let (Some(found), Some(expected)) = (found, expected) else {
        return false;
    };
    found.address == expected.address
        && (found.radiance / expected.radiance - 1.0).abs() < 2f64.powi(-20)
}

#[test]
fn it_is_the_largest_of_all_samples() {
    for text in [TABLE, SMOOTH, WIDE] {
        for integrator in [
            Integrator::Path,
            Integrator::Light,
            Integrator::Bidirectional,
        ] {
            let settings = by(integrator);
            let scene = prepared(text, &settings);
            let job = Job {
                crop: Some(CROP),
                ..job(&scene, settings, SPP, SEED)
            };
            let found = outcome(&job, &Target::CpuF32).stats.largest;
            let samples = samples(&scene, &settings);
            let expected = largest(samples.iter().copied());
            assert!(agree(found, expected), "{found:?}, {expected:?}");
            // Planted: a film that misses that sample.
            let others = samples.iter().filter(|s| Some(**s) != expected);
            assert!(!agree(found, largest(others.copied())));
        }
    }
}

#[test]
fn the_device_has_that_of_the_reference_for_all_tiles_and_dispatches() {
    if cpu_driver().is_none() {
        return;
    }
    for integrator in [Integrator::Path, Integrator::Light] {
        let settings = by(integrator);
        let scene = prepared(TABLE, &settings);
        let job = Job {
            crop: Some(CROP),
            ..job(&scene, settings, SPP, SEED)
        };
        let of = |o: Option<Outcome>| o.expect("a device").stats.largest;
        let reference = outcome(&job, &Target::CpuF32).stats.largest;
        assert_eq!(of(on_device(&job)), reference);
        for (tile_pixels, budget) in [(7, 4000), (100, 40), (1 << 16, 1)] {
            let limits = DispatchLimits {
                tile_pixels,
                budget,
                read_first: true,
                storage_buffer: 1 << 27,
                dispatch_time: DISPATCH_TIME,
            };
            assert_eq!(of(on_device_within(&job, limits)), reference, "{limits:?}");
        }
    }
}

#[test]
fn of_black_samples_there_is_none() {
    let settings = Settings::default();
    let scene = prepared("screen 4 3\ncamera 0 0 5 .3\n", &settings);
    let job = job(&scene, settings, 2, 0);
    assert_eq!(outcome(&job, &Target::CpuF32).stats.largest, None);
}
