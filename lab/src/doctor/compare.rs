//! A device's results compared with the host's, bit by bit.

use super::operations::{EXACT, Float, Word};
use crate::doctor::report::{Operation, Outcome};
use vkpt::reference::math::ulps;

/// Floats: differences are sorted by the kinds of operands and results, and errors cover only normal numbers.
pub fn compare_floats(o: &Float, table: &[[u32; 3]], results: &[u32]) -> Operation {
    let mut found = Operation {
        worst_ulps: Some(0.0),
        allowed_ulps: Some(o.allowed),
        ..blank(o.name, table.len())
    };
    for (row, &bits) in table.iter().zip(results) {
        let x = row.map(f32::from_bits);
        let (expected, got) = ((o.host)(x), f32::from_bits(bits));
        let operands = &x[..o.operands];
        let special = !expected.is_finite() || operands.iter().any(|x| !x.is_finite());
        let truth = (o.truth)(x.map(f64::from));
        // Values that round up to the smallest normal number count, too: a device may flush before it rounds.
        let tiny = truth != 0.0 && truth.abs() < f64::from(f32::MIN_POSITIVE);
        let denormal = tiny || operands.iter().any(|x| x.is_subnormal());
        // Outside of this range of divisors any quotient is allowed.
        let free = o.name == "x ÷ y" && !(2f32.powi(-126)..=2f32.powi(126)).contains(&x[1].abs());
        let ordinary = !special && !denormal && !free;
        if ordinary {
            let error = ulps(got, truth);
            found.worst_ulps = found.worst_ulps.map(|worst| worst.max(error));
        }
        if got.to_bits() == expected.to_bits() || got.is_nan() && expected.is_nan() {
            continue;
        }
        let zeros = got == 0.0 && expected == 0.0;
        *(if special || zeros {
            &mut found.unequal_special
        } else if denormal {
            &mut found.unequal_denormal
        } else {
            &mut found.unequal
        }) += 1;
        found
            .example
            .get_or_insert_with(|| format!("{operands:?} gives {got:e}; host: {expected:e}"));
    }
    let beyond = found.worst_ulps > found.allowed_ulps;
    // A sum in f64 may itself be rounded: 2⁻²⁹ ulp of f32.
    let rounds = o.allowed == EXACT && found.unequal > 0;
    found.outcome = outcome(&found, beyond && o.allowed > EXACT || rounds);
    found
}

/// Bits of floats that were only moved, by a choice between the first two of a row.
pub fn compare_moved(table: &[[u32; 3]], results: &[u32]) -> Operation {
    let mut found = blank("bits of a moved float", table.len());
    for (i, (row, &got)) in table.iter().zip(results).enumerate() {
        let expected = row[i % 2];
        if got == expected {
            continue;
        }
        let x = f32::from_bits(expected);
        *(if x.is_subnormal() {
            &mut found.unequal_denormal
        } else if x.is_nan() || x == 0.0 {
            &mut found.unequal_special
        } else {
            &mut found.unequal
        }) += 1;
        found
            .example
            .get_or_insert_with(|| format!("{expected:#010x} becomes {got:#010x}"));
    }
    found.outcome = outcome(&found, found.unequal > 0);
    found
}

/// Words, which are right or wrong.
pub fn compare_words(o: &Word, table: &[[u32; 3]], results: &[u32]) -> Operation {
    let mut found = blank(o.name, table.len());
    for (row, &got) in table.iter().zip(results) {
        let expected = (o.host)(*row);
        if got != expected {
            found.unequal += 1;
            found.example.get_or_insert_with(|| {
                format!("{row:x?} gives {got:#010x}; host: {expected:#010x}")
            });
        }
    }
    found.outcome = match (found.unequal, o.relied_on) {
        (0, _) => Outcome::Passes,
        (_, true) => Outcome::Fails,
        (_, false) => Outcome::Avoided,
    };
    found
}

fn blank(name: &'static str, compared: usize) -> Operation {
    Operation {
        name,
        outcome: Outcome::Passes,
        compared,
        unequal: 0,
        unequal_denormal: 0,
        unequal_special: 0,
        worst_ulps: None,
        allowed_ulps: None,
        example: None,
    }
}

fn outcome(found: &Operation, wrong: bool) -> Outcome {
    match found.unequal + found.unequal_denormal + found.unequal_special {
        _ if wrong => Outcome::Fails,
        0 => Outcome::Passes,
        _ => Outcome::Differs,
    }
}

#[cfg(test)]
mod tests {
    use super::super::arguments::wide;
    use super::super::operations::{FLOATS, WORDS};
    use super::*;

    /// The host's own results, changed by `change`.
    fn compared(o: &Float, change: impl Fn([f32; 3], f32) -> f32) -> Operation {
        let table = wide();
        let result = |row: &[u32; 3]| {
            let x = row.map(f32::from_bits);
            change(x, (o.host)(x)).to_bits()
        };
        let results: Vec<u32> = table.iter().map(result).collect();
        compare_floats(o, &table, &results)
    }

    #[test]
    fn the_hosts_own_results_pass() {
        for o in &FLOATS {
            let found = compared(o, |_, y| y);
            assert_eq!(found.outcome, Outcome::Passes, "{found:?}");
            assert!(
                found.worst_ulps.is_some_and(|worst| worst <= 0.5),
                "{found:?}"
            );
        }
    }

    #[test]
    fn a_sum_that_rounds_to_zero_fails() {
        let to_zero = |[x, y, _]: [f32; 3], rounded: f32| {
            let exact = f64::from(x) + f64::from(y);
            let beyond = f64::from(rounded).abs() > exact.abs();
            if beyond {
                f32::from_bits(rounded.to_bits() - 1)
            } else {
                rounded
            }
        };
        assert_eq!(compared(&FLOATS[0], to_zero).outcome, Outcome::Fails);
    }

    #[test]
    fn a_quotient_may_be_two_units_off_but_not_three() {
        let off = |by: u32| {
            move |_: [f32; 3], q: f32| match q.is_normal() {
                true => f32::from_bits(q.to_bits() - by),
                false => q,
            }
        };
        // half a unit more than the bound at worst, which is why one that is two off may differ by 2.5
        assert_eq!(compared(&FLOATS[3], off(1)).outcome, Outcome::Differs);
        assert_eq!(compared(&FLOATS[3], off(4)).outcome, Outcome::Fails);
    }

    #[test]
    fn flushed_denormals_differ_and_do_not_fail() {
        let flush = |x: f32| if x.is_subnormal() { 0.0 * x } else { x };
        let product = |[x, y, _]: [f32; 3], _: f32| flush(flush(x) * flush(y));
        let found = compared(&FLOATS[2], product);
        assert_eq!(
            (found.outcome, found.unequal),
            (Outcome::Differs, 0),
            "{found:?}"
        );
        assert!(found.unequal_denormal > 1000);
    }

    #[test]
    fn one_wrong_bit_of_a_word_fails() {
        let table = wide();
        let mut results: Vec<u32> = table.iter().map(|row| (WORDS[8].host)(*row)).collect();
        assert_eq!(
            compare_words(&WORDS[8], &table, &results).outcome,
            Outcome::Passes
        );
        results[77] ^= 1;
        assert_eq!(
            compare_words(&WORDS[8], &table, &results).outcome,
            Outcome::Fails
        );
    }
}
