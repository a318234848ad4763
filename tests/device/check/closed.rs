//! The battery's closed forms, held against tables that vkpt did not compute.

use vkpt::check::closed::interface::dielectric;
use vkpt::settings::Distribution;

/// Rows of normal incidence in a table that vkpt did not compute.
#[test]
fn the_shared_table_of_albedos() {
    let path = "../shared/spec/tables/albedo_dielectric.csv";
    let Ok(table) = std::fs::read_to_string(path) else {
        println!("skipped: {path} is not there");
        return;
    };
    let mut rows = 0;
    for row in table
        .lines()
        .skip(1)
        .map(|l| l.split(',').collect::<Vec<_>>())
    {
        let number = |i: usize| row[i].parse::<f64>().expect("a number");
        let distribution = match row[0] {
            "ggx" => Distribution::Ggx,
            "beckmann" => Distribution::Beckmann,
            _ => continue,
        };
        if number(5) != 1.0 {
            continue;
        }
        let (from, to) = if row[4] == "outside" {
            (1.0, number(3))
        } else {
            (number(3), 1.0)
        };
        let ours = dielectric(distribution, number(2), from, to);
        assert!((ours - number(8)).abs() < 2e-4, "{row:?}: {ours}");
        rows += 1;
    }
    assert!(rows > 0);
}
