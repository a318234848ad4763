//! The selection of cases by a pattern.

use super::case::Case;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_what_lies_below_it_and_stars() {
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
