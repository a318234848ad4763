//! The verdict over all findings.

use serde::Serialize;

use super::{Battery, Operation, Outcome, OwnFunction, SelfTest};
use crate::check::report::{CaseRecord, plain};
use vkpt::report::human::thousands;

/// What to expect of pictures.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Verdict {
    /// No test that pictures depend on failed, and none was skipped.
    pub healthy: bool,
    /// Pictures equal those of the reference in f32, bit for bit.
    pub equal_bits: bool,
    /// The failures and their consequences.
    pub failures: Vec<String>,
    /// Differences from the reference that Vulkan allows.
    pub differences: Vec<String>,
    /// A signal ended the examination before all was examined.
    pub interrupted: bool,
}

impl Verdict {
    /// The same with what the battery found, on the device of this index.
    pub fn with(mut self, battery: &Battery, index: usize) -> Self {
        let Battery { check, error } = battery;
        let failed = check.cases.iter().filter(|case| !case.passed);
        self.failures.extend(failed.map(|c| case(c, index)));
        let error = error.as_ref();
        self.failures
            .extend(error.map(|e| format!("the battery ended early: {e}")));
        self.interrupted = check.interrupted && error.is_none();
        self.healthy = self.failures.is_empty() && !self.interrupted;
        self.equal_bits &= self.healthy;
        self
    }
}

/// A pure function of the three kinds of findings that decide before the battery.
pub fn verdict(tests: &[SelfTest], operations: &[Operation], own: &[OwnFunction]) -> Verdict {
    let (mut failures, mut differences) = (Vec::new(), kinds(operations));
    let normal = |o: &&Operation| o.outcome == Outcome::Fails || o.unequal > 0;
    let tests = tests.iter().map(|t| (t.outcome, test(t)));
    let operations = operations.iter().filter(normal);
    let operations = operations.map(|o| (o.outcome, operation(o)));
    let own = own.iter().map(|f| (f.outcome, function(f)));
    for (outcome, text) in tests.chain(operations).chain(own) {
        match outcome {
            Outcome::Fails => failures.push(text),
            Outcome::Differs => differences.push(text),
            Outcome::Passes | Outcome::Avoided => {}
        }
    }
    Verdict {
        healthy: failures.is_empty(),
        equal_bits: failures.is_empty() && differences.is_empty(),
        failures,
        differences,
        interrupted: false,
    }
}

/// Differences common to several operations: a device that flushes denormals does so in all of them.
fn kinds(operations: &[Operation]) -> Vec<String> {
    let named = |what: &str, count: fn(&Operation) -> usize| {
        let differ = operations.iter().filter(|o| count(o) > 0);
        let names: Vec<&str> = differ.map(|o| o.name).collect();
        (!names.is_empty())
            .then(|| format!("{what} differently, as Vulkan allows: {}", names.join(", ")))
    };
    let denormal = named("handles denormals", |o| o.unequal_denormal);
    let special = named("handles NaN, ∞ or −0", |o| o.unequal_special);
    denormal.into_iter().chain(special).collect()
}

fn test(t: &SelfTest) -> String {
    format!(
        "self-test \"{}\": {} of {} results are wrong; pictures cannot be trusted",
        t.name,
        thousands(t.wrong.into()),
        thousands(t.invocations.into())
    )
}

fn operation(o: &Operation) -> String {
    let (unequal, compared) = (thousands(o.unequal as u64), thousands(o.compared as u64));
    let end = match (o.outcome, o.worst_ulps) {
        (Outcome::Fails, _) => {
            "Vulkan does not allow this, and every picture is affected".to_owned()
        }
        (_, Some(worst)) => format!("up to {worst:.2} ulp, which Vulkan allows"),
        _ => "which Vulkan allows".to_owned(),
    };
    format!(
        "{}: {unequal} of {compared} results of normal numbers differ from the host; {end}",
        o.name
    )
}

fn function(f: &OwnFunction) -> String {
    let bits = format!(
        "{}: {} of {} results differ from the reference",
        f.name,
        thousands(f.unequal),
        thousands(f.compared)
    );
    match f.outcome {
        Outcome::Fails if f.worst_ulps > f.bound_ulps => format!(
            "{bits}, by up to {:.3e} ulp from the true value at {:e}; pictures that use it are wrong",
            f.worst_ulps, f.worst_at
        ),
        Outcome::Fails => {
            format!(
                "{bits} although all arithmetic agrees: the driver does not compute it as written"
            )
        }
        _ => format!("{bits}, within {} ulp of the true value", f.bound_ulps),
    }
}

fn case(case: &CaseRecord, index: usize) -> String {
    let beyond = case.held.iter().filter(|held| !held.passed());
    let beyond = beyond.map(|held| {
        let (measured, bound) = (plain(held.measured), plain(held.bound));
        format!("{} {measured}, at most {bound}", held.what)
    });
    format!(
        "case {}: {}; next: vkpt check --device {index} --case {}",
        case.name,
        beyond.collect::<Vec<_>>().join("; "),
        case.name
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::report::{Held, fixture};

    fn tested(outcome: Outcome) -> SelfTest {
        SelfTest {
            name: "loop",
            outcome,
            invocations: 4096,
            wrong: 3,
            stands_for: "paths",
        }
    }

    fn flushing(name: &'static str) -> Operation {
        Operation {
            name,
            outcome: Outcome::Differs,
            compared: 10,
            unequal: 0,
            unequal_denormal: 2,
            unequal_special: 0,
            worst_ulps: Some(0.5),
            allowed_ulps: Some(0.5),
            example: None,
        }
    }

    #[test]
    fn findings_that_no_picture_depends_on_leave_equal_bits() {
        let found = verdict(
            &[tested(Outcome::Passes), tested(Outcome::Avoided)],
            &[],
            &[],
        );
        assert!(found.healthy && found.equal_bits, "{found:?}");
    }

    #[test]
    fn flushed_denormals_are_one_difference_and_no_failure() {
        let found = verdict(&[], &[flushing("x + y"), flushing("x × y")], &[]);
        assert!(found.healthy && !found.equal_bits);
        let [difference] = &found.differences[..] else {
            panic!("{found:?}");
        };
        assert!(difference.ends_with("x + y, x × y"), "{difference}");
    }

    /// A battery of two cases, the second of which has so many NaN.
    fn battery(nan: f64) -> Battery {
        let case = |name: &str, nan: f64| {
            let held = vec![
                Held::new("NaN", nan, 0.0, "none"),
                Held::new("bias", 1.0, 2.0, ""),
            ];
            fixture::case(name, held)
        };
        let check = fixture::check(vec![case("a/b", 0.0), case("a/c", nan)], false);
        Battery { check, error: None }
    }

    #[test]
    fn a_case_that_fails_is_named_with_the_command_that_explains_it() {
        let probed = verdict(&[], &[flushing("x + y")], &[]);
        let healthy = probed.clone().with(&battery(0.0), 1);
        assert_eq!(healthy, probed);
        let found = probed.with(&battery(3.0), 1);
        assert!(!found.healthy && !found.equal_bits);
        assert_eq!(
            found.failures,
            ["case a/c: NaN 3, at most 0; next: vkpt check --device 1 --case a/c"]
        );
    }

    #[test]
    fn a_battery_that_ended_early_leaves_nobody_healthy() {
        let mut battery = battery(0.0);
        battery.check.interrupted = true;
        let found = verdict(&[], &[], &[]).with(&battery, 0);
        assert!(found.interrupted && found.failures.is_empty());
        assert!(!found.healthy && !found.equal_bits);
        battery.error = Some("a/c: the device was lost".to_owned());
        let found = verdict(&[], &[], &[]).with(&battery, 0);
        assert!(!found.interrupted && !found.healthy);
        assert!(found.failures[0].contains("a/c: the device was lost"));
    }

    #[test]
    fn one_failure_is_enough() {
        let found = verdict(&[tested(Outcome::Fails)], &[flushing("x + y")], &[]);
        assert!(!found.healthy && !found.equal_bits);
        assert!(found.failures[0].contains("3 of 4,096"), "{found:?}");
    }
}
