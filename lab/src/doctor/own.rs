//! vkpt's own elementary functions: compared with the reference in f32 by bits, with f64 by units of the last place.

use rayon::prelude::*;

use super::arguments::ROWS;
use super::bench::{Bench, Subject};
use crate::doctor::report::{Operation, Outcome, OwnFunction};
use vkpt::gpu::GpuError;
use vkpt::reference::math::{Real, elementary, ulps};

/// A function, its twin and the truth.
pub struct Own {
    pub name: &'static str,
    pub file: &'static str,
    pub expression: &'static str,
    pub range: &'static str,
    /// The bits of its arguments: 0 to here.
    last: u32,
    f32: fn(f32) -> f32,
    f64: fn(f64) -> f64,
    /// Units of the last place: `reference::math::elementary` derives them.
    bound: f64,
}

const TURN: u32 = 0x3f80_0000;

pub const OWN: [Own; 7] = [
    Own {
        name: "sincos_2pi, sine",
        file: "math/elementary/sincos",
        expression: "sincos_2pi(x).x",
        range: "[0, 1]",
        last: TURN,
        f32: |u| elementary::sincos_2pi(u).0,
        f64: |u| <f64 as Real>::sincos_2pi(u).0,
        bound: 1.4,
    },
    Own {
        name: "sincos_2pi, cosine",
        file: "math/elementary/sincos",
        expression: "sincos_2pi(x).y",
        range: "[0, 1]",
        last: TURN,
        f32: |u| elementary::sincos_2pi(u).1,
        f64: |u| <f64 as Real>::sincos_2pi(u).1,
        bound: 1.4,
    },
    Own {
        name: "exp",
        file: "math/elementary/exp",
        expression: "exp(x)",
        range: "all",
        last: u32::MAX,
        f32: elementary::exp,
        f64: f64::exp,
        bound: 1.0,
    },
    Own {
        name: "expm1",
        file: "math/elementary/expm1",
        expression: "expm1(x)",
        range: "all",
        last: u32::MAX,
        f32: elementary::expm1,
        f64: f64::exp_m1,
        bound: 1.0,
    },
    Own {
        name: "log1p",
        file: "math/elementary/log1p",
        expression: "log1p(x)",
        range: "all",
        last: u32::MAX,
        f32: elementary::log1p,
        f64: f64::ln_1p,
        bound: 1.0,
    },
    Own {
        name: "erfc",
        file: "math/elementary/erfc",
        expression: "erfc(x)",
        range: "all",
        last: u32::MAX,
        f32: elementary::erfc,
        f64: <f64 as Real>::erfc,
        bound: 6.0,
    },
    Own {
        name: "erfc_inverse",
        file: "math/elementary/erfc_inverse",
        expression: "erfc_inverse(x)",
        range: "[0, 2]",
        last: 0x4000_0000,
        f32: elementary::erfc_inverse,
        f64: <f64 as Real>::erfc_inverse,
        bound: 4.0,
    },
];

/// The findings for some of the arguments.
#[derive(Clone, Copy, Default)]
struct Found {
    compared: u64,
    unequal: u64,
    worst: f64,
    at: f32,
}

impl Found {
    fn and(self, other: Self) -> Self {
        let worse = if other.worst > self.worst {
            other
        } else {
            self
        };
        Self {
            compared: self.compared + other.compared,
            unequal: self.unequal + other.unequal,
            ..worse
        }
    }
}

/// Every function at about a million arguments throughout its range, or at `every` one; fewer if the bench is stopped.
pub fn functions(
    bench: &Bench,
    operations: &[Operation],
    every: bool,
) -> Result<Vec<OwnFunction>, GpuError> {
    let same = |o: &Operation| matches!(o.outcome, Outcome::Passes | Outcome::Avoided);
    let rounds = operations.iter().all(same);
    OWN.iter()
        .take_while(|_| !bench.stopped())
        .map(|own| examine(bench, own, rounds, every))
        .collect()
}

fn examine(bench: &Bench, own: &Own, rounds: bool, every: bool) -> Result<OwnFunction, GpuError> {
    // Odd, so that no low bit of the arguments is always the same.
    let stride = if every { 1 } else { (own.last / ROWS) | 1 };
    let caller = bench.caller(&Subject::float(own.file, own.expression), ROWS as usize)?;
    let mut found = Found::default();
    let arguments = u64::from(own.last) / u64::from(stride) + 1;
    for begin in (0..arguments).step_by(ROWS as usize) {
        if bench.stopped() {
            break;
        }
        let end = arguments.min(begin + u64::from(ROWS));
        // An argument's bits are below 2³².
        let bits = |k: u64| (k * u64::from(stride)) as u32;
        let table: Vec<[u32; 3]> = (begin..end)
            .into_par_iter()
            .map(|k| [bits(k), 0, 0])
            .collect();
        let results = caller.call(&table)?;
        let each = table
            .par_iter()
            .zip(&results)
            .map(|(row, got)| compare(own, row[0], *got));
        found = found.and(each.reduce(Found::default, Found::and));
    }
    Ok(OwnFunction {
        name: own.name,
        outcome: outcome(&found, own.bound, rounds),
        range: own.range,
        compared: found.compared,
        unequal: found.unequal,
        worst_ulps: found.worst,
        worst_at: found.at,
        bound_ulps: own.bound,
    })
}

/// Below this the last place of a result depends on denormals, which a device may flush.
const LEAST: f64 = f32::MIN_POSITIVE as f64 * (1 << f32::MANTISSA_DIGITS) as f64;

/// One result. Denormals, and results that depend on them, do not count for the error.
fn compare(own: &Own, bits: u32, got: u32) -> Found {
    let (x, got) = (f32::from_bits(bits), f32::from_bits(got));
    let expected = (own.f32)(x);
    let truth = (own.f64)(f64::from(x));
    let judged = x.is_normal() && truth.is_finite() && truth.abs() >= LEAST;
    let same = got.to_bits() == expected.to_bits() || got.is_nan() && expected.is_nan();
    Found {
        compared: 1,
        unequal: u64::from(!same),
        worst: if judged { ulps(got, truth) } else { 0.0 },
        at: x,
    }
}

/// If all arithmetic rounds like the host's, different bits are a fault of the driver's compiler.
fn outcome(found: &Found, bound: f64, rounds: bool) -> Outcome {
    match found {
        f if f.worst > bound => Outcome::Fails,
        f if f.unequal == 0 => Outcome::Passes,
        _ if rounds => Outcome::Fails,
        _ => Outcome::Differs,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a flushed correction leaves of erfc: 60 units off, and no picture hangs on it.
    #[test]
    fn small_results_of_flushed_denormals_are_reported_and_not_judged() {
        let erfc = &OWN[5];
        for (x, judged) in [(9.08f32, false), (8.0, true)] {
            let off = f32::from_bits(elementary::erfc(x).to_bits() + 60);
            let found = compare(erfc, x.to_bits(), off.to_bits());
            assert_eq!(found.unequal, 1);
            assert_eq!(found.worst > erfc.bound, judged, "{x}");
        }
    }

    #[test]
    fn one_other_bit_is_seen_and_judged_by_how_the_device_rounds() {
        let exp = &OWN[2];
        let x = 1.5f32;
        let right = compare(exp, x.to_bits(), elementary::exp(x).to_bits());
        assert_eq!((right.compared, right.unequal), (1, 0));
        assert_eq!(outcome(&right, exp.bound, true), Outcome::Passes);
        // the neighbour that is on the truth's other side
        let expected = elementary::exp(x);
        let truth = f64::from(x).exp();
        let other = if f64::from(expected) > truth {
            expected.next_down()
        } else {
            expected.next_up()
        };
        let other = compare(exp, x.to_bits(), other.to_bits());
        assert_eq!(other.unequal, 1);
        assert_eq!(outcome(&other, exp.bound, true), Outcome::Fails);
        assert_eq!(outcome(&other, exp.bound, false), Outcome::Differs);
        let far = compare(exp, x.to_bits(), (expected * 1.001).to_bits());
        assert_eq!(outcome(&right.and(far), exp.bound, false), Outcome::Fails);
    }
}
