//! The experiment as a text.

use insta::assert_snapshot;
use vkpt_lab::converge::report::table;

use super::records::{curve, experiment};

/// The first variant ends below the reference's own error; the second has three times the error of the first.
#[test]
fn every_variant_has_a_table_and_is_compared_with_the_first() {
    let steps = [(0.1, 0.4), (0.2, 0.21), (0.4, 0.1), (0.8, 1e-7)];
    let (a, b) = (curve(&steps), curve(&steps.map(|(s, e)| (s, 3.0 * e))));
    let mut record = experiment("a b.scn", &[("connect=mis", &a), ("connect=bsdf", &b)]);
    record.crop = Some([0, 0, 2, 1]);
    record.models_differ = true;
    assert_snapshot!(table(&record));
}

#[test]
fn one_variant_has_no_name_and_no_comparison() {
    let curve = curve(&[(0.1, 0.4), (0.2, 0.2), (0.4, 0.1), (0.8, 0.05)]);
    assert_snapshot!(table(&experiment("a.scn", &[("", &curve)])));
}
