//! The report of a run: the table, the failures, the JSON.

use vkpt_lab::check::report::{Held, failures, table};

use crate::common::checks::run;

#[test]
fn the_table_fits_a_hundred_columns_beside_the_mark_of_what_fails() {
    let text = table(&run());
    let columns = |l: &str| l.trim_end_matches(" FAILS").chars().count();
    assert!(text.lines().all(|l| columns(l) <= 100), "{text}");
    let line = |name: &str| {
        text.lines()
            .find(|l| l.trim_start().starts_with(name))
            .expect("a line")
    };
    for word in [
        "0.12 %", "1.2e-7", "1.0e0", "2.2500", "0.8346", "0.50", "250 ms",
    ] {
        assert!(line("ggx/1e-3").contains(word), "{word}: {text}");
    }
    assert!(line("rough-cylinder/2^-17").ends_with("FAILS"), "{text}");
    assert!(text.lines().any(|l| l == "furnace"), "{text}");
    assert!(text.ends_with("2 cases, 1 fails, 1 min 01 s\n"), "{text}");
}

#[test]
fn failures_tell_the_case_what_is_stiff_and_each_bound() {
    let told = failures(&run());
    assert_eq!(told.len(), 1, "{told:?}");
    for words in [
        "furnace/rough-cylinder/2^-17: something stiff",
        "weight: 4.5000, at most 1: no path",
        "NaN: 2, at most 0: none",
    ] {
        assert!(told[0].contains(words), "{words}: {told:?}");
    }
}

#[test]
fn the_json_has_every_bound_and_null_for_what_is_infinite() {
    let json = serde_json::to_value(run()).expect("JSON");
    assert_eq!(json["cases"][1]["held"][0]["margin"], 4.5);
    assert!(json["cases"][1]["margin"].is_null());
    assert_eq!(json["cases"][0]["passed"], true);
    assert_eq!(json["passed"], false);
}

#[test]
fn a_nan_is_below_no_bound() {
    assert!(!Held::new("x", f64::NAN, 1.0, "").passed());
    assert!(!Held::new("x", 1e-300, 0.0, "").passed());
    assert!(Held::new("x", 0.0, 0.0, "").passed() && Held::new("x", 1.0, 1.0, "").passed());
}
