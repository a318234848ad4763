//! Materials and media, and where pbrt has another model of them.

use super::*;

/// A scene whose line 5 is this material, with words before it.
fn of(words: &str, brdf: &str) -> String {
    format!("screen 8 8\ncamera 0 0 9 1\n{words}\n#\nbrdf {brdf}\nsphere 0 0 0 1\n")
}

fn material(exported: &Exported) -> &Statement {
    let material = exported.only("MakeNamedMaterial");
    assert_eq!(material.words, ["material-5"]);
    assert_eq!(exported.only("NamedMaterial").words, ["material-5"]);
    material
}

#[test]
fn kd_is_a_reflectance() {
    let exported = export(&of("#", ".5 .25 0 0 0 0 1"));
    let diffuse = material(&exported);
    assert_eq!(diffuse.plugin(), "diffuse");
    check(diffuse, "rgb reflectance", &[0.5, 0.25, 0.0]);
}

#[test]
fn mirrors_that_reflect_all_light_have_an_imaginary_index() {
    for alpha in ["0", ".3"] {
        let exported = export(&of("#", &format!("0 0 0 1 1 1 {alpha}")));
        let mirror = material(&exported);
        assert_eq!(mirror.plugin(), "conductor");
        // Of the index n + ik light is reflected by ((n − 1)² + k²)/((n + 1)² + k²) along the normal: 1 for n = 0.
        let [n, k] = ["spectrum eta", "spectrum k"].map(|name| mirror.numbers_of(name));
        let along = |i: usize| {
            ((n[i] - 1.0).powi(2) + k[i].powi(2)) / ((n[i] + 1.0).powi(2) + k[i].powi(2))
        };
        assert_eq!([along(1), along(3)], [1.0; 2]);
        // Over all that is visible.
        assert!(n[0] <= 360.0 && n[2] >= 830.0 && k[0] == n[0] && k[2] == n[2]);
        assert_eq!(mirror.parameters.len() > 3, alpha != "0");
    }
}

#[test]
fn glass_has_its_index_and_its_width() {
    for alpha in ["0", ".3"] {
        let exported = export(&of(
            "fresnel exact",
            &format!("0 0 0 0 0 0 {alpha} 1 1 1 1.25"),
        ));
        let glass = material(&exported);
        assert_eq!(glass.plugin(), "dielectric");
        check(glass, "float eta", &[1.25]);
        if alpha != "0" {
            check(glass, "float roughness", &[0.3]);
            // pbrt would take another number for it.
            assert_eq!(glass.values("bool remaproughness"), ["false"]);
        }
        assert!(exported.all("MakeNamedMedium").is_empty());
    }
}

#[test]
fn absorption_is_a_medium_in_which_nothing_scatters() {
    let exported = export(&of("fresnel exact", "0 0 0 0 0 0 0 1 .5 .25 1.5"));
    let medium = exported.only("MakeNamedMedium");
    assert_eq!(
        (medium.words[0].as_str(), medium.plugin()),
        ("medium-5", "homogeneous")
    );
    // −ln 1, −ln ½, −ln ¼
    let ln2 = std::f64::consts::LN_2;
    check(medium, "rgb sigma_a", &[0.0, ln2, 2.0 * ln2]);
    check(medium, "rgb sigma_s", &[0.0; 3]);
    assert_eq!(exported.only("MediumInterface").words, ["medium-5", ""]);
}

#[test]
fn an_index_of_1_is_an_interface_or_nothing() {
    let stained = export(&of("#", "0 0 0 0 0 0 0 .5 .5 .5 1"));
    assert_eq!(material(&stained).plugin(), "interface");
    let nothing = export(&of("#", "0 0 0 0 0 0 0 1 1 1 1"));
    assert!(nothing.all("Shape").is_empty() && nothing.all("MakeNamedMaterial").is_empty());
}

#[test]
fn another_model_gives_a_warning_with_its_line() {
    let message = |scene: &str| {
        let warnings = export(scene).warnings.into_iter();
        let words = warnings.map(|w| format!("{}: {}", w.line, &w.reason[..7]));
        Vec::from_iter(words).join(", ")
    };
    let exact = |brdf: &str| message(&of("fresnel exact", brdf));
    assert_eq!(message(&of("#", ".5 .5 .5 0 0 0 1")), "");
    assert_eq!(message(&of("#", ".5 .5 .4 0 0 0 1")), "5: a colou");
    assert_eq!(exact("0 0 0 0 0 0 0 .5 .5 .4 1.5"), "5: a colou");
    // A parameter that exact glass does not use.
    assert_eq!(exact("0 0 0 .1 .2 .3 0 .5 .5 .5 1.5"), "");
    assert_eq!(
        exact("0 0 0 0 0 0 .2 .5 .4 .5 1.5"),
        "5: a colou, 5: a rough"
    );
    assert_eq!(message(&of("#", "0 0 0 1 1 1 .2")), "5: a rough");
    let outside = of("background .1 .2 .3", ".5 .5 .5 0 0 0 1");
    assert_eq!(message(&outside), "3: a colou");
}
