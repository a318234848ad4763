//! Pictures of glTF files, compared with closed forms.

use std::f64::consts::PI;
use std::path::Path;

use serde_json::json;
use vkpt::prepared::{Prepared, prepare};
use vkpt::render::Target;
use vkpt::scene::parse_model;
use vkpt::settings::{Sampler, Settings};

use crate::common::models::{Model, glass, lamp, matte};
use crate::common::render::{job, outcome};
use crate::common::stats::p_of_mean;
use crate::common::table::Table;

/// Samples are independent, as the test of their mean has it.
fn settings() -> Settings {
    let mut settings = Settings::default();
    settings.estimator.sampler = Sampler::Random;
    settings
}

fn prepared(model: &Model) -> Prepared {
    let read = parse_model(&model.glb(), Path::new("model.glb"), true, None);
    let read = read.unwrap_or_else(|errors| panic!("{:?}", errors.diagnostics));
    prepare(&read.scene, &settings(), Some([16, 16])).expect("prepared")
}

/// The pixels of each channel, which all see the same.
fn channels(model: &Model, spp: u32) -> [Vec<f64>; 3] {
    let prepared = prepared(model);
    let film = outcome(&job(&prepared, settings(), spp, 1), &Target::CpuF64).film;
    [0, 1, 2].map(|c| film.rgb.iter().map(|p| f64::from(p[c])).collect())
}

/// Below this a mean is taken for another one. With the nine that should pass it is crossed once in 10⁵ seeds.
const LEVEL: f64 = 1e-6;

/// Angles within a pixel, below 1e-4, change a cosine by less than 1e-8, and f32 of the film's digits by 6e-8.
const ROUNDING: f64 = 1e-6;

/// A slab whose attenuationColor is transmitted over `distance`, seen along its normal before a lamp of radiance 1.
fn slab(thickness: f64, distance: f64) -> Model {
    let mut model = Model::seen_from([0.0, 0.0, 10.0], 1e-5);
    let wide = 1000.0;
    model.cuboid(
        [-wide, -wide, -thickness],
        [wide, wide, 0.0],
        glass([0.9, 0.5, 0.1], distance),
    );
    let behind = -thickness - 1.0;
    model.cuboid(
        [-wide, -wide, behind - 1.0],
        [wide, wide, behind],
        lamp(1.0),
    );
    model
}

/// T of slab_beer.csv along the normal, for the transmittance of the colour of [`slab`] over the thickness.
fn transmitted() -> [f64; 3] {
    let table = Table::open("slab_beer.csv");
    ["0.9", "0.5", "0.1"].map(|kt| {
        let is_it = |r: &crate::common::table::Row| {
            r.text("n") == "1.5" && r.text("cos") == "1" && r.text("Kt") == kt
        };
        table.rows().find(is_it).expect("a row").number("T")
    })
}

#[test]
fn a_slab_transmits_as_much_as_in_the_table() {
    for thickness in [1.0, 0.25] {
        let seen = channels(&slab(thickness, thickness), 256);
        for (channel, t) in seen.iter().zip(transmitted()) {
            let p = p_of_mean(channel, t, ROUNDING);
            assert!(p > LEVEL, "thickness {thickness}, T {t}: p = {p:e}");
        }
    }
}

/// A slab absorbs too little if attenuationColor is taken for the transmittance of a unit, and not of a distance of 2 units.
#[test]
fn another_distance_is_noticed() {
    let seen = channels(&slab(1.0, 2.0), 256);
    for (channel, t) in seen.iter().zip(transmitted()) {
        assert!(p_of_mean(channel, t, ROUNDING) < LEVEL, "T {t}");
    }
}

/// Of a unit of the file a thousandth is absorbed as by its own distances: Kt per unit would be .1^1000, which f64 lacks.
#[test]
fn media_that_absorb_within_a_thousandth_of_a_unit_are_rendered() {
    let mut model = Model::seen_from([0.0, 0.0, 0.01], 1e-5);
    let thickness = 5e-4;
    model.cuboid(
        [-1.0, -1.0, -thickness],
        [1.0, 1.0, 0.0],
        glass([0.9, 0.5, 0.1], thickness),
    );
    model.cuboid([-1.0, -1.0, -0.02], [1.0, 1.0, -0.01], lamp(1.0));
    let seen = channels(&model, 256);
    for (channel, t) in seen.iter().zip(transmitted()) {
        let p = p_of_mean(channel, t, ROUNDING);
        assert!(p > LEVEL, "T {t}: p = {p:e}");
    }
}

/// A floor y = 0 of albedo 1/2, seen from above at the point that is `across` from the foot of a point light of 7 cd.
fn lit(height: f64, across: f64) -> Model {
    let mut model = Model::unseen();
    let perspective = json!({"yfov": 2e-5, "aspectRatio": 1, "znear": 0.01});
    model.document["cameras"] = json!([{"type": "perspective", "perspective": perspective}]);
    // Turned about X by −90°, it looks down −Y.
    let half = 0.5f64.sqrt();
    model.add_node(
        json!({"camera": 0, "translation": [across, 10, 0], "rotation": [-half, 0, 0, half]}),
    );
    let s = 20.0;
    let corners = [[-s, 0.0, s], [s, 0.0, s], [s, 0.0, -s], [-s, 0.0, -s]];
    model.mesh(&corners, &[0, 1, 2, 0, 2, 3], matte([0.5; 3]));
    let light = json!({"type": "point", "color": [1, 0.5, 0.25], "intensity": 7});
    model.light([0.0, height, 0.0], light);
    model
}

/// L = ρ/π · I cos θ/d² on a diffuse floor: a ball sends the irradiance of a point as far as all of it is above the horizon.
#[test]
fn a_point_light_sends_its_intensity() {
    for (height, across) in [(2.0, 0.5), (2.0, 2.0), (1.0, 3.0)] {
        let d2: f64 = height * height + across * across;
        let seen = channels(&lit(height, across), 64);
        for (channel, colour) in seen.iter().zip([1.0, 0.5, 0.25]) {
            let expected = 0.5 / PI * 7.0 * colour * height / d2.powf(1.5);
            // A pixel sees 2e-4 of the floor, over which the irradiance changes by 3 · 2e-4/d to both sides alike: in the mean
            // by the square of that.
            let rounding = expected * 1e-6;
            let p = p_of_mean(channel, expected, rounding);
            assert!(p > LEVEL, "{height}, {across}: p = {p:e}");
            // Without the cosine, and a hundredth too bright.
            for wrong in [expected * d2.sqrt() / height, expected * 1.01] {
                let differs = (wrong - expected).abs() > rounding;
                let p = p_of_mean(channel, wrong, rounding);
                assert!(!differs || p < LEVEL, "{height}, {across}: p = {p:e}");
            }
        }
    }
}
