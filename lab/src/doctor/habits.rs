//! How a driver compiles arithmetic that is not marked `NoContraction`: the reason why vkpt marks all of its own.

use super::arguments::cancelling;
use super::bench::{Bench, Subject};
use crate::doctor::report::Habit;
use vkpt::gpu::GpuError;
use vkpt::kernel::unaudited::Arithmetic;
use vkpt::report::human::thousands;

/// Contraction, algebra, and the roundings of `fma`.
pub fn habits(bench: &Bench) -> Result<Vec<Habit>, GpuError> {
    let table = cancelling();
    let call = |expression, arithmetic| {
        let subject = Subject::float("", expression).unaudited(arithmetic);
        let results = bench.call(&subject, &table)?;
        Ok::<_, GpuError>(
            results
                .into_iter()
                .map(f32::from_bits)
                .collect::<Vec<f32>>(),
        )
    };
    let product = call("x * y + z", Arithmetic::DriversChoice)?;
    let sum = call("(x + y) - x", Arithmetic::DriversChoice)?;
    let fma = call("fma(x, y, z)", Arithmetic::AsWritten)?;
    let fused = |[x, y, z]: [f32; 3]| x.mul_add(y, z);
    let apart = |[x, y, z]: [f32; 3]| x * y + z;
    Ok(vec![
        Habit {
            name: "x·y + z, unmarked",
            choice: shares(
                &table,
                &product,
                &[("two roundings", &apart), ("one rounding", &fused)],
            ),
        },
        Habit {
            name: "(x + y) − x, unmarked",
            choice: shares(
                &table,
                &sum,
                &[
                    ("as written", &|[x, y, _]| (x + y) - x),
                    ("y, by algebra", &|[_, y, _]| y),
                ],
            ),
        },
        Habit {
            name: "fma(x, y, z)",
            choice: shares(
                &table,
                &fma,
                &[("one rounding", &fused), ("two roundings", &apart)],
            ),
        },
    ])
}

/// A way to compute something, with its name.
type Way<'a> = (&'a str, &'a dyn Fn([f32; 3]) -> f32);

/// The way that explains all results, or how many results each explains that no earlier way does.
fn shares(table: &[[u32; 3]], results: &[f32], ways: &[Way]) -> String {
    let rows = || table.iter().map(|row| row.map(f32::from_bits)).zip(results);
    let explains = |(_, way): &&Way, x: [f32; 3], got: f32| way(x) == got;
    if let Some((name, _)) = ways
        .iter()
        .find(|w| rows().all(|(x, got)| explains(w, x, *got)))
    {
        return (*name).to_owned();
    }
    let mut counts = vec![0u64; ways.len() + 1];
    for (x, got) in rows() {
        let which = ways.iter().position(|w| explains(&w, x, *got));
        counts[which.unwrap_or(ways.len())] += 1;
    }
    let names = ways.iter().map(|(name, _)| *name).chain(["neither"]);
    let counted = names.zip(counts).filter(|(_, n)| *n > 0);
    let counted: Vec<String> = counted
        .map(|(name, n)| format!("{name}: {}", thousands(n)))
        .collect();
    counted.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mixture_is_reported_in_numbers() {
        let table = [[1f32, 2.0, 0.0].map(f32::to_bits); 3];
        let ways: [Way; 2] = [("sum", &|[x, y, _]| x + y), ("product", &|[x, y, _]| x * y)];
        assert_eq!(shares(&table, &[3.0; 3], &ways), "sum");
        assert_eq!(shares(&table, &[2.0; 3], &ways), "product");
        assert_eq!(
            shares(&table, &[2.0, 3.0, 5.0], &ways),
            "sum: 1, product: 1, neither: 1"
        );
    }
}
