//! The battery itself: names, scenes, bounds.

use std::collections::HashSet;

use vkpt::prepared::prepare;
use vkpt_lab::check::{Expectation, battery};

use super::{fails_by, ran};

#[test]
fn names_are_unique_and_groups_stand_together() {
    let all = battery();
    let names: HashSet<&str> = all.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names.len(), all.len());
    let mut groups: Vec<&str> = all.iter().map(|c| c.group()).collect();
    groups.dedup();
    assert_eq!(groups.len(), groups.iter().collect::<HashSet<_>>().len());
    for case in &all {
        // The table has 29 columns for the text after the group.
        let below = case.name.split_once('/').map_or("", |(_, name)| name);
        assert!(
            (1..=29).contains(&below.len()) && !case.about.is_empty(),
            "{}",
            case.name
        );
        let others = case.expectations.iter().filter_map(|e| match e {
            Expectation::SameMean { case, .. } | Expectation::SameBits { case, .. } => {
                Some(case.as_str())
            }
            _ => None,
        });
        for other in others {
            assert!(
                names.contains(other),
                "{} is compared with {other}, which is no case",
                case.name
            );
        }
    }
}

/// Each has a scene that is read and prepared, and each is compared with something other than f64.
#[test]
fn every_case_can_be_rendered_and_has_an_expectation() {
    for case in battery() {
        let (scene, warnings) = case
            .scene()
            .unwrap_or_else(|e| panic!("{}: {e}", case.name));
        prepare(&scene, &case.settings, None).unwrap_or_else(|e| panic!("{}: {e}", case.name));
        let warned_of = case
            .expectations
            .iter()
            .any(|e| matches!(e, Expectation::Warning(_)));
        assert!(
            warnings.is_empty() || warned_of,
            "{}: {warnings:?}",
            case.name
        );
        assert!(
            case.stiffness.close() > 0.0 && case.stiffness.diverged() <= 1.0,
            "{}",
            case.name
        );
    }
}

/// One of each group, without a planted fault.
#[test]
fn sound_kernels_pass() {
    let names = [
        "alpha/ggx/.3",
        "furnace/rough-sphere/2^17",
        "light/tiny",
        "camera/one-pixel",
        "mesh/one-triangle",
    ];
    let Some(check) = ran(&names, &[]) else {
        return;
    };
    for name in names {
        assert_eq!(fails_by(&check, name), Vec::<&str>::new(), "{check:#?}");
    }
    assert!(check.passed && !check.interrupted);
}
