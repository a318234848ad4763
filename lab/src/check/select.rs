//! The selection of cases: by a pattern, and that of `vkpt doctor`.

use super::case::Case;

/// The short selection, which `vkpt doctor` runs: quick cases of every group whose kernels differ most, in
/// the order of the battery. On lavapipe 18 CPU-seconds, most of them to compile 27 kernels, and 4 once Mesa's cache has those.
pub const SHORT: [&str; 27] = [
    "alpha/beckmann/.3",
    "alpha/ggx/1e-3",
    "alpha/phong/1e4",
    "angle/1e-5/out",
    "angle/critical/in",
    "interface/phong-0.01/1.0001/out",
    "interface/ggx-0/0.666667/out",
    "interface/ggx-0.3/1.5/in",
    "furnace/smooth-sphere/1e-30",
    "furnace/rough-box/1",
    "furnace/smooth-mesh/1e5",
    "yardstick/1e-4",
    "far/smooth-mesh",
    "medium/glass-0.5/1e0",
    "medium/glass-0.999999/1e6",
    "light/tiny",
    "light/in-glass",
    "light/10000",
    "surroundings/sun",
    "camera/on-ball-in",
    "lens/wide",
    "bounces/glass-box",
    "contact/slab-1e-6",
    "coincident/cubes",
    "coincident/flush-lamp",
    "mesh/needle",
    "beyond/too-narrow",
];

/// Whether `pattern` matches `name`: it is that case or one below it, or `*` matches the text between.
pub fn matches(pattern: &str, name: &str) -> bool {
    match pattern.split_once('*') {
        None => name
            .strip_prefix(pattern)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with('/')),
        Some((before, after)) => {
            let Some(rest) = name.strip_prefix(before) else {
                return false;
            };
            after.is_empty() || ends(after, rest)
        }
    }
}

/// Whether `pattern` matches some suffix of `name`.
fn ends(pattern: &str, name: &str) -> bool {
    let (before, after) = pattern
        .split_once('*')
        .map_or((pattern, None), |(b, a)| (b, Some(a)));
    let places = name.match_indices(before);
    let mut rests = places.map(|(i, _)| &name[i + before.len()..]);
    rests.any(|rest| match after {
        None => rest.is_empty(),
        Some("") => true,
        Some(after) => ends(after, rest),
    })
}

/// The cases of a run: those that the pattern matches, without the slow ones if `quick`.
pub fn select<'a>(all: &'a [Case], pattern: Option<&str>, quick: bool) -> Vec<&'a Case> {
    let meant = |case: &&Case| pattern.is_none_or(|p| matches(p, &case.name));
    all.iter()
        .filter(meant)
        .filter(|case| !(quick && case.slow))
        .collect()
}

/// The cases of these names, in the battery's order.
pub fn named<'a>(all: &'a [Case], names: &[&str]) -> Vec<&'a Case> {
    let meant = |case: &&Case| names.contains(&case.name.as_str());
    all.iter().filter(meant).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::battery;

    /// Each exists, none is slow, and every group has one.
    #[test]
    fn the_short_selection_is_of_cases_of_every_group() {
        let all = battery();
        let short = named(&all, &SHORT);
        let names: Vec<&str> = short.iter().map(|case| case.name.as_str()).collect();
        assert_eq!(names, SHORT);
        assert!(short.iter().all(|case| !case.slow));
        let groups = |cases: &[&Case]| {
            let mut groups: Vec<String> = cases.iter().map(|c| c.group().to_owned()).collect();
            groups.dedup();
            groups
        };
        assert_eq!(groups(&short), groups(&all.iter().collect::<Vec<_>>()));
    }

    #[test]
    fn names_groups_and_stars_select_cases() {
        let name = "alpha/ggx/1e-3";
        for yes in [
            name,
            "alpha",
            "alpha/ggx",
            "*",
            "alpha*",
            "*/1e-3",
            "*ggx*",
            "a*x/1*3",
            "alpha/*/1e-3",
        ] {
            assert!(matches(yes, name), "{yes}");
        }
        for no in [
            "alp",
            "ggx",
            "alpha/ggx/1e-30",
            "*1e",
            "b*",
            "alpha/*/1e",
            "",
        ] {
            assert!(!matches(no, name), "{no}");
        }
    }
}
