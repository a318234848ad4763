//! The report of `vkpt check`: the table, the failures, the JSON.

use insta::assert_snapshot;
use vkpt_lab::check::report::{Held, failures, table};

use crate::common::checks::run;

#[test]
fn the_table_fits_a_hundred_columns_beside_the_mark_of_failures() {
    let text = table(&run());
    let columns = |l: &str| l.trim_end_matches(" FAILS").chars().count();
    assert!(text.lines().all(|l| columns(l) <= 100), "{text}");
    assert_snapshot!(text);
}

#[test]
fn failures_name_the_case_its_difficulty_and_each_bound() {
    assert_snapshot!(failures(&run()).join("\n\n"));
}

#[test]
fn the_json_has_every_bound_and_null_for_infinity() {
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
