//! `golden_bsdf.csv`, 216 rows of D, G1, F, both conventions of the value, and densities (model.md, "Golden values").

use vkpt::reference::bsdf::distribution::{distribution_d, distribution_g1};
use vkpt::reference::bsdf::facet::{Facet, facet};
use vkpt::reference::bsdf::fresnel::fresnel;
use vkpt::reference::bsdf::reflection::reflection_half_vector;
use vkpt::reference::bsdf::transmission::transmission_half_vector;
use vkpt::reference::bsdf::{Interaction, bsdf_eval};
use vkpt::reference::math::{Real, Vec3, dot3, vec3};
use vkpt::settings::{LobeChoice, Normals, Settings};

use super::support::surface::{dielectric, estimator, seen};
use crate::common::table::{Row, Table};

/// The columns of a row that the model computes, by name.
fn computed<F: Real>(row: &Row) -> Vec<(&'static str, f64)> {
    let vector = |name: &str| {
        let component = |axis: &str| F::new(row.number(&format!("{name}_{axis}")));
        vec3(component("x"), component("y"), component("z"))
    };
    let material = dielectric(row.distribution(), row.number("param"), row.number("ior"));
    let (wo, wi) = (vector("wo"), vector("wi"));
    let at = seen::<F>(&material, row.outside(), wo);
    let m = if wi.z > F::zero() {
        reflection_half_vector(wo, wi)
    } else {
        transmission_half_vector(&at, wi)
    };
    let radiance = estimator(LobeChoice::Fresnel, Normals::Distribution);
    let mut flux = radiance;
    flux.model.radiance_scaling = false;
    let eval = |settings: &Settings| bsdf_eval(settings, &at, wi);
    let c = dot3(wo, m);
    vec![
        ("c_om", c.f64()),
        ("F", fresnel(&at, c).x.f64()),
        ("Dm", distribution_d(&at.material, m).f64()),
        ("G1_wo", distribution_g1(&at.material, wo).f64()),
        ("G1_wi", distribution_g1(&at.material, wi).f64()),
        ("fcos_flux", eval(&flux).value.x.f64()),
        ("fcos_radiance", eval(&radiance).value.x.f64()),
        ("pdf_Dcos_fresnelchoice", eval(&radiance).pdf.f64()),
        (
            "pdf_vndf_fresnelchoice",
            own_visible_pdf(&radiance, &at, wi, m),
        ),
    ]
}

/// Density by the visible normals of the material's own D and the model's G1, which are not quite the renderer's.
fn own_visible_pdf<F: Real>(
    settings: &Settings,
    at: &Interaction<F>,
    wi: Vec3<F>,
    m: Vec3<F>,
) -> f64 {
    let Facet { c, pm, .. } = facet(settings, at, wi, m);
    let own = distribution_g1(&at.material, at.wo) * c * distribution_d(&at.material, m) / at.wo.z;
    (bsdf_eval(settings, at, wi).pdf * (own / pm)).f64()
}

/// Cells whose relative error exceeds `tolerance`, as text.
fn failures<F: Real>(table: &Table, tolerance: f64, planted: f64) -> Vec<String> {
    let mut found = Vec::new();
    for (i, row) in table.rows().enumerate() {
        for (name, value) in computed::<F>(&row) {
            let (value, expected) = (value * planted, row.number(name));
            let near = (value - expected).abs() <= tolerance * expected.abs();
            if !near {
                found.push(format!("row {i}, {name}: {value:e}, not {expected:e}"));
            }
        }
    }
    found
}

#[test]
fn every_column_in_f64() {
    let table = Table::open("golden_bsdf.csv");
    assert_eq!(table.rows().count(), 216);
    let bad = failures::<f64>(&table, 1e-12, 1.0);
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

#[test]
fn every_column_in_f32() {
    let table = Table::open("golden_bsdf.csv");
    let bad = failures::<f32>(&table, 5e-4, 1.0);
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

#[test]
fn a_planted_error_is_seen_in_every_cell() {
    let table = Table::open("golden_bsdf.csv");
    let cells = 216 * 9;
    assert_eq!(failures::<f32>(&table, 5e-4, 1.01).len(), cells);
    assert_eq!(failures::<f64>(&table, 1e-12, 1.0 + 1e-11).len(), cells);
}
