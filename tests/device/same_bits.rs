//! A picture depends on scene, settings, samples, seed and device only, bit for bit: not on the crop, the tiles, the
//! slices of samples, the dispatches that a path is spread over, or an interruption. A CPU driver and the reference
//! in f32 make the same one.

use std::sync::atomic::{AtomicBool, Ordering};

use vkpt::film::Film;
use vkpt::render::{DISPATCH_TIME, DispatchLimits, End, Job, Target, render, render_on};
use vkpt::settings::Settings;

use crate::common::render::{
    difference, job, on_device, on_device_within, outcome, prepared, prepared_file,
};
use crate::common::scenes::{
    FLUSH, LENS, MANY, SMOOTH, TABLE, WIDE, flush_meshes, scene_files, surroundings,
};
use crate::common::settings::{estimators, models};
use crate::common::surroundings::uneven_sky;
use crate::common::{self, cpu_driver};

pub fn same(a: &Film, b: &Film, what: &str) {
    if let Some(difference) = difference(a, b) {
        panic!("{what}: {difference}");
    }
}

/// The job on the device and by the reference.
fn films(job: &Job) -> Vec<(&'static str, Film)> {
    let cpu = ("cpu-f32", outcome(job, &Target::CpuF32).film);
    let gpu = on_device(job).map(|o| ("the device", o.film));
    gpu.into_iter().chain([cpu]).collect()
}

#[test]
fn one_ulp_in_one_channel_is_a_difference() {
    let mut film = Film {
        width: 2,
        height: 1,
        rgb: vec![[1.0; 3]; 2],
    };
    let right = film.clone();
    assert_eq!(difference(&film, &right), None);
    film.rgb[1][2] = 1.0 + f32::EPSILON;
    assert!(
        difference(&film, &right).is_some_and(|d| d.starts_with("1 of 2 pixels, first at 1,0"))
    );
}

#[test]
fn the_same_seed_makes_the_same_picture_and_another_seed_another() {
    let settings = Settings::default();
    let scene = prepared(TABLE, &settings);
    let [a, b, c] = [3, 3, 4].map(|seed| films(&job(&scene, settings, 4, seed)));
    for (((name, a), (_, b)), (_, c)) in a.iter().zip(&b).zip(&c) {
        same(a, b, name);
        assert!(difference(a, c).is_some(), "{name}: seed 4 as seed 3");
    }
}

#[test]
fn a_crop_is_a_piece_of_the_picture() {
    crops_are_pieces(Settings::default());
}

/// Each crop of a picture, on the device and by the reference, equals the whole picture there.
pub fn crops_are_pieces(settings: Settings) {
    let scene = prepared(TABLE, &settings);
    let whole = films(&job(&scene, settings, 4, 1));
    for crop in [
        [0, 0, 32, 24],
        [5, 3, 22, 20],
        [31, 23, 32, 24],
        [0, 7, 32, 8],
    ] {
        let [left, top, right, bottom] = crop.map(|x| x as usize);
        let cropped = Job {
            crop: Some(crop),
            ..job(&scene, settings, 4, 1)
        };
        for ((name, whole), (_, part)) in whole.iter().zip(films(&cropped)) {
            let rows = whole.rgb.chunks(32).take(bottom).skip(top);
            let piece = Film {
                width: (right - left) as u32,
                height: (bottom - top) as u32,
                rgb: rows.flat_map(|row| row[left..right].to_vec()).collect(),
            };
            same(&part, &piece, &format!("{name}, crop {crop:?}"));
        }
    }
}

#[test]
fn tiles_and_dispatches_leave_no_trace() {
    limits_leave_no_trace(Settings::default(), 6);
}

/// Tiles of less than a row, of some rows, of all; paths that change dispatch at every bounce, now and then, never; primitives
/// read first or where they are tried.
pub fn limits_leave_no_trace(settings: Settings, spp: u32) {
    let scene = prepared(TABLE, &settings);
    let job = job(&scene, settings, spp, 1);
    let Some(whole) = on_device(&job) else { return };
    for (tile_pixels, budget, read_first) in [
        (7, 4000, true),
        (100, 40, true),
        (1 << 16, 1, false),
        (1 << 16, 40, true),
        (768, 4000, false),
        (768, 4000, true),
    ] {
        let limits = DispatchLimits {
            tile_pixels,
            budget,
            read_first,
            storage_buffer: 1 << 27,
            dispatch_time: DISPATCH_TIME,
        };
        let other = on_device_within(&job, limits).expect("the same device");
        same(&whole.film, &other.film, &format!("{limits:?}"));
        assert_eq!(whole.stats.rays, other.stats.rays, "{limits:?}");
    }
}

#[test]
fn an_interrupted_picture_is_that_of_the_samples_it_has() {
    let settings = Settings::default();
    let scene = prepared(TABLE, &settings);
    let endless = job(&scene, settings, 1 << 31, 1);
    let check = |name: &str, render: &dyn Fn(&Job, &AtomicBool) -> (Film, u32, bool)| {
        let stop = AtomicBool::new(false);
        let (film, spp, interrupted) = render(&endless, &stop);
        assert!(interrupted && spp >= 3, "{name}: {spp} samples");
        let again = render(&job(&scene, settings, spp, 1), &AtomicBool::new(false));
        assert_eq!((again.1, again.2), (spp, false), "{name}");
        same(&film, &again.0, &format!("{name}, {spp} samples"));
    };
    check("cpu-f32", &|job, stop| {
        let mut enough =
            |p: vkpt::render::Progress| stop.store(p.samples_done >= 3, Ordering::Relaxed);
        let o = render(job, &Target::CpuF32, stop, &mut enough).expect("a rendering");
        (o.film, o.spp, o.end == End::Interrupted)
    });
    let Some(device) = common::device() else {
        return;
    };
    let limits = DispatchLimits::of(device).expect("a probe");
    check("the device", &|job, stop| {
        let mut enough =
            |p: vkpt::render::Progress| stop.store(p.samples_done >= 3, Ordering::Relaxed);
        let o = render_on(job, device, limits, stop, &mut enough).expect("a rendering");
        (o.film, o.spp, o.end == End::Interrupted)
    });
}

fn device_equals_reference(job: &Job, name: &str) {
    let device = on_device(job).expect("a device");
    let reference = outcome(job, &Target::CpuF32);
    same(&device.film, &reference.film, name);
    let counts = |o: &vkpt::render::Outcome| {
        (
            o.stats.rays,
            o.stats.long_paths,
            o.stats.underflows,
            o.stats.dropped,
            o.stats.largest,
        )
    };
    assert_eq!(
        counts(&device),
        counts(&reference),
        "{name}: rays, long paths, underflows, dropped samples, the largest"
    );
    assert!(
        device.film.rgb.iter().flatten().any(|&x| x > 0.0),
        "{name} is black"
    );
}

#[test]
fn the_device_equals_the_reference_with_each_setting() {
    if cpu_driver().is_none() {
        return;
    }
    let all = [("the default", Settings::default())];
    let sky = uneven_sky();
    for (name, settings) in all.into_iter().chain(estimators()).chain(models()) {
        let scene = prepared(WIDE, &settings);
        device_equals_reference(&job(&scene, settings, 8, 1), name);
        for text in [MANY, &surroundings(sky.path())] {
            let scene = prepared(text, &settings);
            device_equals_reference(&job(&scene, settings, 4, 1), name);
        }
    }
    let (square, cube) = (common::meshes::square(), common::meshes::cube());
    let meshes = flush_meshes(square.path(), cube.path());
    for text in [TABLE, SMOOTH, FLUSH, LENS, &meshes] {
        let scene = prepared(text, &Settings::default());
        device_equals_reference(&job(&scene, Settings::default(), 8, 1), text);
    }
}

/// The project's scenes, with the default settings and with the hand-out's.
#[test]
fn the_device_equals_the_reference_on_every_scene() {
    if cpu_driver().is_none() {
        return;
    }
    for path in scene_files() {
        for settings in [Settings::default(), Settings::handout()] {
            let scene = prepared_file(&path, &settings, Some([40, 30]));
            device_equals_reference(&job(&scene, settings, 4, 1), &path.display().to_string());
        }
    }
}

/// An index-matched interface among shapes of one kind, a light and a floor: kernels without any switch, on which
/// Mesa 22.3's compiler crashed.
#[test]
fn the_device_equals_the_reference_where_all_shapes_are_of_one_kind() {
    if cpu_driver().is_none() {
        return;
    }
    let cube = common::meshes::cube();
    let mesh = cube.path().display().to_string();
    let kinds = [
        ["sphere 0 0 4 1", "sphere 0 0 -51 51", "sphere 0 0 1 1"].map(String::from),
        [
            "box -1 -1 4 2 2 1",
            "box -5 -5 -1 10 10 1",
            "box -1 -1 .1 2 2 2",
        ]
        .map(String::from),
        [
            "cylinder -1 0 4 2 0 0 1",
            "cylinder 0 0 -1 0 0 1 9",
            "cylinder 0 0 .1 0 0 2 1",
        ]
        .map(String::from),
        ["0 0 4 .5", "0 0 -9 9", "0 0 1.1 1"].map(|place| format!("mesh {mesh} {place}")),
    ];
    for [light, floor, stain] in kinds {
        let text = format!(
            "screen 32 24\ncamera 0 -6 3 .35 x 65\nlight 6 5 4\n{light}\n\
             brdf .6 .5 .4 0 0 0 1\n{floor}\nbrdf 0 0 0 0 0 0 1 .5 .7 .9 1\n{stain}\n"
        );
        let settings = Settings::default();
        let scene = prepared(&text, &settings);
        device_equals_reference(&job(&scene, settings, 4, 1), &text);
    }
}

/// 8192 × 8192 pixels: a gibibyte of film in tiles. A crop of it must be the same pixels.
#[test]
#[ignore = "3 GiB of memory, a minute"]
fn a_picture_larger_than_a_buffer() {
    let settings = Settings::default();
    let text = TABLE.replace("screen 32 24", "screen 8192 8192");
    let scene = prepared(&text, &settings);
    let Some(whole) = on_device(&job(&scene, settings, 1, 1)) else {
        return;
    };
    let crop = [4000, 5000, 4200, 5100];
    let part = on_device(&Job {
        crop: Some(crop),
        ..job(&scene, settings, 1, 1)
    });
    let rows = whole.film.rgb.chunks(8192).take(5100).skip(5000);
    let piece = Film {
        width: 200,
        height: 100,
        rgb: rows.flat_map(|row| row[4000..4200].to_vec()).collect(),
    };
    same(
        &part.expect("the same device").film,
        &piece,
        "crop of 8192×8192",
    );
}
