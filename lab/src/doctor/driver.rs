//! GLSL's own elementary functions compared with f64. No rendering kernel may call one (`kernel::audit`); their errors
//! here are the reason. Never a failure.

use super::bench::{Bench, Subject};
use super::builtins::{Allowed, BUILTINS, Builtin, ROWS};
use crate::doctor::report::{DriverFunction, Worst};
use vkpt::gpu::GpuError;
use vkpt::kernel::unaudited::Arithmetic;
use vkpt::reference::math::ulps;

/// All functions; a dispatch each.
pub fn functions(bench: &Bench) -> Result<Vec<DriverFunction>, GpuError> {
    let examine = |b: &Builtin| {
        let subject = Subject::float("", b.expression).unaudited(Arithmetic::AsWritten);
        let table: Vec<[u32; 3]> = (0..ROWS).map(|i| b.arguments.row(i)).collect();
        Ok(compare(b, &table, &bench.call(&subject, &table)?))
    };
    BUILTINS.iter().map(examine).collect()
}

fn compare(b: &Builtin, table: &[[u32; 3]], results: &[u32]) -> DriverFunction {
    let [mut units, mut absolute, mut relative] = [Worst::default(); 3];
    let mut within = true;
    for (row, got) in table.iter().zip(results) {
        let [x, y, _] = row.map(f32::from_bits);
        let (x64, y64, got) = (f64::from(x), f64::from(y), f32::from_bits(*got));
        let truth = (b.truth)(x64, y64);
        let error = (f64::from(got) - truth).abs();
        let error = if error.is_nan() { f64::INFINITY } else { error };
        raise(&mut absolute, error, x);
        within &= match b.allowed {
            Allowed::Absolute(bound) => error <= bound,
            _ => true,
        };
        // Denormals may be flushed.
        if truth.abs() < f64::from(f32::MIN_POSITIVE) {
            continue;
        }
        let (in_units, share) = (ulps(got, truth), error / truth.abs());
        raise(&mut units, in_units, x);
        raise(&mut relative, share, x);
        within &= match b.allowed {
            Allowed::Ulps(bound) => in_units <= bound(x64),
            Allowed::Relative(bound) => share <= bound(x64, y64),
            _ => true,
        };
    }
    DriverFunction {
        name: b.name,
        range: b.range,
        ulps: units,
        absolute,
        relative,
        allowed: b.words,
        within: (!matches!(b.allowed, Allowed::Anything)).then_some(within),
    }
}

fn raise(worst: &mut Worst, error: f64, at: f32) {
    if error > worst.error {
        *worst = Worst { error, at };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn compared(b: &Builtin, spoil: impl Fn(f64, f64) -> f64) -> DriverFunction {
        let table: Vec<[u32; 3]> = (0..ROWS).map(|i| b.arguments.row(i)).collect();
        let result = |row: &[u32; 3]| {
            let [x, y, _] = row.map(f32::from_bits).map(f64::from);
            (spoil(x, (b.truth)(x, y)) as f32).to_bits()
        };
        let results: Vec<u32> = table.iter().map(result).collect();
        compare(b, &table, &results)
    }

    #[test]
    fn the_truth_rounded_is_half_a_unit_off_at_most_and_within_every_bound() {
        for b in &BUILTINS {
            let found = compared(b, |_, truth| truth);
            assert!(
                found.ulps.error <= 0.5 && found.within != Some(false),
                "{found:?}"
            );
        }
    }

    #[test]
    fn results_beyond_the_bound_are_reported_with_their_argument() {
        let sine = compared(
            &BUILTINS[0],
            |x, truth| if x > 3.0 { truth + 0.001 } else { truth },
        );
        assert_eq!(sine.within, Some(false));
        assert!(
            (sine.absolute.error - 0.001).abs() < 1e-6 && sine.absolute.at > 3.0,
            "{sine:?}"
        );
        let root = compared(&BUILTINS[12], |_, truth| {
            truth * (1.0 + 4.5 * 2f64.powi(-23))
        });
        assert_eq!(root.within, Some(false));
        let nan = compared(&BUILTINS[4], |_, _| f64::NAN);
        assert_eq!((nan.within, nan.absolute.error), (None, f64::INFINITY));
    }
}
