//! Materials.

use super::*;

/// A scene whose line 5 is this material, with words before it.
fn of(words: &str, brdf: &str) -> String {
    format!("screen 8 8\ncamera 0 0 9 1\n{words}\n#\nbrdf {brdf}\nsphere 0 0 0 1\n")
}

#[test]
fn opaque_surfaces_are_two_sided() {
    let exported = export(&of("#", ".5 .25 0 0 0 0 1"));
    let document = document(&exported);
    let outer = plugins(&document, "bsdf")[0];
    assert_eq!(
        (kind(&outer), outer.attribute("id")),
        ("twosided", Some("bsdf-5"))
    );
    let diffuse = bsdf(&document, 5);
    assert_eq!(kind(&diffuse), "diffuse");
    check(&diffuse, "reflectance", &[0.5, 0.25, 0.0]);
}

#[test]
fn schlicks_reflectance_is_all_metal() {
    let exported = export(&of("#", "0 0 0 .9 .5 .25 .25"));
    let document = document(&exported);
    let metal = bsdf(&document, 5);
    assert_eq!(kind(&metal), "principled");
    check(&metal, "base_color", &[0.9, 0.5, 0.25]);
    check(&metal, "metallic", &[1.0]);
    // α is its square.
    check(&metal, "roughness", &[0.5]);
}

#[test]
fn mirrors_that_reflect_all_light_need_no_reflectance() {
    for (alpha, plugin) in [("0", "conductor"), (".3", "roughconductor")] {
        let exported = export(&of("#", &format!("0 0 0 1 1 1 {alpha}")));
        let document = document(&exported);
        let mirror = bsdf(&document, 5);
        assert_eq!((kind(&mirror), word(&mirror, "material")), (plugin, "none"));
        if plugin == "roughconductor" {
            assert_eq!(word(&mirror, "distribution"), "ggx");
            check(&mirror, "alpha", &[0.3]);
        }
    }
}

#[test]
fn glass_stands_in_air_of_index_1() {
    for (alpha, plugin) in [("0", "dielectric"), (".3", "roughdielectric")] {
        let exported = export(&of(
            "fresnel exact",
            &format!("0 0 0 0 0 0 {alpha} 1 1 1 1.25"),
        ));
        let document = document(&exported);
        let glass = bsdf(&document, 5);
        assert_eq!(kind(&glass), plugin);
        check(&glass, "int_ior", &[1.25]);
        check(&glass, "ext_ior", &[1.0]);
        if plugin == "roughdielectric" {
            assert_eq!(word(&glass, "distribution"), "ggx");
            check(&glass, "alpha", &[0.3]);
        }
        // Nothing absorbs.
        assert!(plugins(&document, "medium").is_empty());
    }
}

#[test]
fn absorption_is_a_medium_in_which_nothing_scatters() {
    let exported = export(&of("fresnel exact", "0 0 0 0 0 0 0 1 .5 .25 1.5"));
    let document = document(&exported);
    let medium = plugins(&document, "medium")[0];
    assert_eq!(
        (kind(&medium), medium.attribute("id")),
        ("homogeneous", Some("medium-5"))
    );
    check(&medium, "albedo", &[0.0]);
    // −ln 1, −ln ½, −ln ¼
    check(&medium, "sigma_t", &[0.0, 0.5, 1.0]);
    check(&medium, "scale", &[2.0 * std::f64::consts::LN_2]);
    let sphere = plugins(&document, "shape")[0];
    let interior = parameter(&sphere, "interior");
    assert_eq!(interior.attribute("id"), Some("medium-5"));
}

#[test]
fn an_index_of_1_is_a_medium_without_a_surface_or_nothing() {
    let stained = export(&of("#", "0 0 0 0 0 0 0 .5 .5 .5 1"));
    assert_eq!(kind(&bsdf(&document(&stained), 5)), "null");
    let nothing = export(&of("#", "0 0 0 0 0 0 0 1 1 1 1"));
    let document = document(&nothing);
    assert!(plugins(&document, "shape").is_empty() && plugins(&document, "bsdf").is_empty());
}

#[test]
fn an_exponent_becomes_a_width_by_the_word_of_the_scene() {
    // √(2/(6 + 2))
    let exported = export(&of("distribution ggx", "0 0 0 .5 .5 .5 6"));
    let document = document(&exported);
    check(&bsdf(&document, 5), "roughness", &[0.5f64.sqrt()]);
}
