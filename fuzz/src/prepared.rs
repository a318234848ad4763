//! Prepared scenes.

use glam::DVec3;
use vkpt::prepared::cdf::CDF_TOTAL;
use vkpt::prepared::{LightKind, Material, MaterialKind, NONE, Prepared, prepare};
use vkpt::scene::Scene;
use vkpt::settings::Settings;

/// A legal scene can be prepared with either preset, or is refused with the line at fault.
pub fn is_prepared(scene: &Scene) {
    for settings in [Settings::default(), Settings::handout()] {
        match prepare(scene, &settings, Some([16, 12])) {
            Ok(prepared) => {
                is_finite(&prepared);
                is_lit(&prepared);
                prepared.warnings.iter().for_each(|w| super::has_message(w));
            }
            Err(error) => {
                super::has_message(&error);
                assert!(error.to_string().contains("line "), "{error}");
            }
        }
    }
}

/// Everything that goes to the device is finite in single precision.
fn is_finite(prepared: &Prepared) {
    let finite = |v: DVec3| v.as_vec3().is_finite();
    let camera = prepared.camera;
    assert!([camera.eye, camera.right, camera.up, camera.forward].map(finite) == [true; 4]);
    if let Some(lens) = &prepared.lens {
        assert!(finite(lens.right) && finite(lens.up), "{lens:?}");
        assert!(
            (lens.blur as f32).is_finite() && lens.blur > 0.0,
            "{lens:?}"
        );
    }
    for s in &prepared.primitives.spheres {
        assert!(finite(s.centre) && s.radius as f32 > 0.0, "{s:?}");
    }
    for b in &prepared.primitives.boxes {
        assert!(finite(b.lo) && finite(b.hi), "{b:?}");
    }
    for c in &prepared.primitives.cylinders {
        assert!([c.base, c.u, c.v, c.w].map(finite) == [true; 4], "{c:?}");
        assert!((c.height as f32).is_finite() && c.height > 0.0, "{c:?}");
    }
    for t in &prepared.primitives.triangles {
        assert!(t.v.map(finite) == [true; 3], "{t:?}");
    }
    assert!(
        prepared
            .primitives
            .normals
            .as_flattened()
            .iter()
            .all(|n| finite(*n))
    );
    prepared.materials.iter().for_each(is_finite_material);
    is_listed(prepared);
}

fn is_finite_material(m: &Material) {
    for v in [m.kd, m.f0, m.sigma, m.radiance] {
        assert!(v.as_vec3().is_finite(), "{m:?}");
    }
    // The exponent of a smooth surface may be infinite, and is never read.
    let alpha = match m.kind {
        MaterialKind::Glossy | MaterialKind::RoughDielectric | MaterialKind::WeakDielectric => {
            m.alpha
        }
        _ => 1.0,
    };
    let lobes = [alpha, m.width, m.p_d, m.p_r];
    let ior = [m.eta, m.one_minus_eta2, m.d];
    let mut numbers = lobes.iter().chain(ior.as_flattened());
    assert!(numbers.all(|n| (*n as f32).is_finite()), "{m:?}");
}

/// The lists of coincident faces name faces of the scene, and no face names itself.
fn is_listed(prepared: &Prepared) {
    for (i, shape) in (0..).zip(&prepared.shapes) {
        for prim in shape.faces() {
            for c in prepared.primitives.coincident.of(i, prim) {
                let other = &prepared.shapes[c.shape as usize];
                assert!(
                    other.kind == c.kind && other.faces().contains(&c.prim),
                    "{c:?}"
                );
                assert!((c.shape, c.prim) != (i, prim), "{c:?}");
            }
        }
    }
}

/// The tables by which lights are chosen are complete, and name shapes that name them.
fn is_lit(prepared: &Prepared) {
    let is_whole = |cdf: &[u32]| {
        let ends = (cdf.first(), cdf.last()) == (Some(&0), Some(&CDF_TOTAL));
        assert!(ends && cdf.is_sorted(), "{cdf:?}");
    };
    if !prepared.lights.is_empty() {
        assert_eq!(prepared.light_cdf.len(), prepared.lights.len() + 1);
        is_whole(&prepared.light_cdf);
    }
    for (i, light) in prepared.lights.iter().enumerate() {
        match light.kind {
            LightKind::Background => assert_eq!(light.shape, NONE),
            _ => assert_eq!(prepared.shapes[light.shape as usize].light, i as u32),
        }
        if light.kind == LightKind::Mesh {
            let cdf = &prepared.triangle_cdf[light.cdf as usize..];
            is_whole(&cdf[..=light.count as usize]);
        }
    }
}
