//! Checks whether two parts belong to the same picture.

use super::Header;
use crate::report::{Difference, Job, SettingsRecord};

/// The first difference between the origins of two parts; `None` if they can be joined.
pub fn differs(a: &Header, b: &Header) -> Option<Difference> {
    let mut pairs = words(a).into_iter().zip(words(b));
    pairs.find_map(|((name, a), (_, b))| match name {
        SCENE => Difference::unshown(name, [a, b]),
        _ => Difference::new(name, [a, b]),
    })
}

const SCENE: &str = "the scene or one of its meshes";

/// Everything that the samples depend on, by name, except the device's rounding.
fn words(header: &Header) -> Vec<(&'static str, String)> {
    let Job {
        size: [width, height],
        crop,
        seed,
        settings,
        ..
    } = &header.record.job;
    let SettingsRecord {
        fresnel,
        distribution,
        absorption,
        radiance_scaling,
        max_depth,
        integrator,
        lobe,
        normals,
        roulette,
        connect,
        lights,
        sampler,
    } = settings;
    let crop = crop.map_or("none".to_owned(), |[x0, y0, x1, y1]| {
        format!("{x0},{y0},{x1},{y1}")
    });
    let depth = max_depth.map_or("none".to_owned(), |depth| depth.to_string());
    let scaling = if *radiance_scaling { "on" } else { "off" };
    vec![
        (SCENE, header.digest.clone()),
        ("vkpt's version", header.record.version.to_string()),
        ("--size", format!("{width}x{height}")),
        ("--crop", crop),
        ("--seed", seed.to_string()),
        ("--fresnel", fresnel.clone()),
        ("--distribution", distribution.clone()),
        ("--absorption", absorption.clone()),
        ("--radiance-scaling", scaling.to_owned()),
        ("--max-depth", depth),
        ("--integrator", integrator.clone()),
        ("--lobe", lobe.clone()),
        ("--normals", normals.clone()),
        ("--roulette", roulette.clone()),
        ("--connect", connect.clone()),
        ("--lights", lights.clone()),
        ("--sampler", sampler.clone()),
    ]
}
