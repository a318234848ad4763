//! The battery's closed forms, compared with tables that vkpt did not compute.

use vkpt_lab::check::closed::interface::dielectric;

use crate::common::table::{Row, Table};

/// Rows of normal incidence of GGX and Beckmann.
#[test]
fn albedos_at_normal_incidence() {
    let table = Table::open("albedo_dielectric.csv");
    let smith = |row: &Row| matches!(row.text("D"), "ggx" | "beckmann");
    let rows = table
        .rows()
        .filter(|row| smith(row) && row.number("cos") == 1.0);
    let mut compared = 0;
    for row in rows {
        let ior = row.number("ior");
        let (from, to) = if row.outside() {
            (1.0, ior)
        } else {
            (ior, 1.0)
        };
        let ours = dielectric(row.distribution(), row.number("param"), from, to);
        let sum = row.number("R_plus_T");
        assert!((ours - sum).abs() < 2e-4, "{row:?}: {ours}");
        compared += 1;
    }
    // two distributions, two widths, both sides
    assert_eq!(compared, 8);
}
