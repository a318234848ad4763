//! The light of classes of paths next to a device's picture: the reference makes them, from the samples that the device had.

use std::sync::atomic::AtomicBool;

use vkpt::film::Channel;
use vkpt::path_class::PathClass;
use vkpt::render::{Job, light_classes};
use vkpt::settings::Integrator;

use crate::common;
use crate::common::render::{job, on_device, prepared};
use crate::common::scenes::TABLE;
use crate::common::settings::by;

/// The largest relative difference of the sums of classes from a picture.
fn off(picture: &[[f32; 3]], channels: &[Channel]) -> f64 {
    let difference = |(i, rgb): (usize, &[f32; 3])| {
        (0..3).fold(0.0, |worst, c| {
            let of = |class: &[Channel]| f64::from(class[c].values[i]);
            let sum: f64 = channels.chunks(3).map(of).sum();
            let whole = f64::from(rgb[c]);
            f64::max(worst, (sum - whole).abs() / sum.max(whole).max(1e-300))
        })
    };
    let all = picture.iter().enumerate().map(difference);
    all.fold(0.0, f64::max)
}

/// Within 1e-5, as up to 40 surfaces anywhere (`tests/library/classes/sums.rs`).
#[test]
fn classes_add_up_to_the_picture_of_a_cpu_device() {
    if common::cpu_driver().is_none() {
        return;
    }
    let patterns = ["EL", "ED.*L", "EG.*L", "E<RS>.*L", "E<TS>.*L"];
    let classes = patterns.map(|pattern| PathClass::new(pattern).expect("a class"));
    for integrator in [
        Integrator::Path,
        Integrator::Light,
        Integrator::Bidirectional,
    ] {
        let mut settings = by(integrator);
        settings.model.max_depth = Some(8);
        let scene = prepared(TABLE, &settings);
        let job = Job {
            classes: &classes,
            ..job(&scene, settings, 12, 3)
        };
        let picture = on_device(&job).expect("a device").film.rgb;
        let channels = light_classes(&job, 12, &AtomicBool::new(false), &mut |_| {});
        let channels = channels.expect("nobody stops it");
        let worst = off(&picture, &channels);
        assert!(worst <= 1e-5, "{integrator:?}: {worst}");
        // A class that is missing is noticed, and so are the samples of another seed.
        let without_diffuse = [&channels[..3], &channels[6..]].concat();
        assert!(off(&picture, &without_diffuse) > 1e-2, "{integrator:?}");
        let other = Job { seed: 4, ..job };
        let other = light_classes(&other, 12, &AtomicBool::new(false), &mut |_| {});
        assert!(off(&picture, &other.expect("nobody stops it")) > 1e-2);
    }
}
