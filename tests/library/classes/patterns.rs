//! Which paths a pattern has, and which patterns are none.

use proptest::prelude::*;
use vkpt::path_class::{Letter, PathClass, Side};

use super::class;

/// Small letters are transmission.
fn letters(text: &str) -> Vec<Letter> {
    let letter = |c| match c {
        'D' => Letter::D,
        'G' => Letter::G(Side::R),
        'g' => Letter::G(Side::T),
        'S' => Letter::S(Side::R),
        's' => Letter::S(Side::T),
        other => panic!("{other}"),
    };
    text.chars().map(letter).collect()
}

/// A pattern, the surfaces of paths that match it, and of paths that do not.
const TABLE: [(&str, &[&str], &[&str]); 25] = [
    ("EL", &[""], &["D", "S", "DD"]),
    ("EDL", &["D"], &["", "G", "S", "DD"]),
    ("E.L", &["D", "G", "S"], &["", "DD"]),
    (
        "E.D.S*L",
        &["DDD", "SDG", "GDDSS", "SDSSSS"],
        &["D", "DD", "DDDD", "DDSD"],
    ),
    ("E.*L", &["", "D", "GSDGS"], &[]),
    ("EDS+L", &["DS", "DSSS"], &["D", "S", "DSD", "DDS"]),
    ("ES?DL", &["D", "SD"], &["SSD", "S", ""]),
    ("E[DG]L", &["D", "G"], &["S", "", "DG"]),
    ("E[^S]*L", &["", "D", "GD"], &["S", "DSD"]),
    ("E[^DG]+L", &["S", "SS"], &["", "SD"]),
    ("E(DS)*L", &["", "DS", "DSDS"], &["D", "DSD", "SD"]),
    // No alternative hides a longer one behind it.
    ("E(D|DS|G)L", &["D", "DS", "G"], &["S", "GS", "DSG"]),
    ("EDL|ES+L", &["D", "S", "SS"], &["", "DS"]),
    ("(EDL)", &["D"], &["", "G"]),
    ("E(S|)DL", &["D", "SD"], &["SSD"]),
    ("EGSL", &["GS", "gS", "Gs", "gs"], &["SG", "GG", "g"]),
    ("E.L", &["D", "G", "g", "S", "s"], &["", "gs"]),
    ("ETL", &["g", "s"], &["D", "G", "S"]),
    ("ERL", &["D", "G", "S"], &["g", "s"]),
    ("ET+RL", &["gsD", "sS"], &["D", "g", "gDD"]),
    ("E[^T]*L", &["", "DGS"], &["g", "DsD"]),
    ("E[DT]L", &["D", "g", "s"], &["G", "S"]),
    ("E[^DT]L", &["G", "S"], &["D", "g", "s"]),
    ("E<TS>+<RG>L", &["sG", "ssG"], &["SG", "sg", "gG"]),
    ("E<RD>L|E<TG>L", &["D", "g"], &["G", "s", ""]),
];

#[test]
fn a_pattern_has_the_paths_whose_whole_strings_match() {
    for (pattern, has, has_not) in TABLE {
        let class = class(pattern);
        for path in has {
            assert!(class.has(&letters(path)), "{pattern} and E{path}L");
        }
        for path in has_not {
            assert!(!class.has(&letters(path)), "{pattern} and E{path}L");
        }
    }
}

/// The message names the error, and what is allowed.
#[test]
fn invalid_patterns_are_refused() {
    let long = format!("E{}L", "D".repeat(200));
    for (pattern, why) in [
        ("", "no path matches it"),
        ("D*L", "no path matches it"),
        ("ED+", "no path matches it"),
        ("E", "no path matches it"),
        ("LDE", "no path matches it"),
        ("EDEL", "no path matches it"),
        ("ED|SL", "no path matches it"),
        ("ed+l", "'e' has no meaning in it"),
        ("ED L", "' ' has no meaning in it"),
        ("EXL", "'X' has no meaning in it"),
        ("EgL", "'g' has no meaning in it"),
        ("E>L", "'>' has no meaning in it"),
        ("E<TSL", "a < lacks its >"),
        ("E<T>L", "<T> is not R or T followed by D, G or S"),
        ("E<>L", "<> is not R or T followed by D, G or S"),
        ("E<ST>L", "<ST> is not R or T followed by D, G or S"),
        ("E<T.>L", "<T.> is not R or T followed by D, G or S"),
        ("E<TSS>L", "<TSS> is not R or T followed by D, G or S"),
        (
            "E<TD>L",
            "<TD> is not R or T followed by D, G or S, or no surface does both",
        ),
        (
            "E[^RT]L",
            "[^RT] is not a non-empty set of D, G, S, R and T",
        ),
        ("E[.]L", "[.] is not a non-empty set of D, G, S, R and T"),
        ("E[g]L", "[g] is not a non-empty set of D, G, S, R and T"),
        ("ED{2}L", "'{' has no meaning in it"),
        ("E^DL", "'^' has no meaning in it"),
        ("ED]L", "']' has no meaning in it"),
        ("E\\.L", "'\\\\' has no meaning in it"),
        ("E[DL", "a [ lacks its ]"),
        ("E[]L", "[] is not a non-empty set of D, G, S, R and T"),
        ("E[^]L", "[^] is not a non-empty set of D, G, S, R and T"),
        (
            "E[^DGS]L",
            "[^DGS] is not a non-empty set of D, G, S, R and T",
        ),
        ("E[DL]L", "[DL] is not a non-empty set of D, G, S, R and T"),
        (
            "E[D-S]L",
            "[D-S] is not a non-empty set of D, G, S, R and T",
        ),
        ("E(DL", "its brackets or repetitions do not match"),
        ("ED)L", "its brackets or repetitions do not match"),
        ("*EDL", "its brackets or repetitions do not match"),
        ("E(?D)L", "its brackets or repetitions do not match"),
        ("E.*D................L", "it is too large"),
        (&long, "more than 200 letters"),
    ] {
        let error = PathClass::new(pattern).expect_err(pattern).to_string();
        let printed = format!("{pattern:?} is not a class of paths: {why}");
        assert!(error.starts_with(&printed), "{error}");
        assert!(error.contains("Write E for the eye"), "{error}");
    }
}

/// A channel's name begins with its layer's, up to the last dot.
#[test]
fn the_name_of_a_layer_has_no_dot() {
    assert_eq!(class("E.D.S*L").layer(), "light:E_D_S*L");
    assert_eq!(class("E[^S]L").layer(), "light:E[^S]L");
}

proptest! {
    /// Any input is a class of some path or an error.
    #[test]
    fn any_text_is_read_or_refused(text in "[EDGSRTL.*+?|()<>\\[\\]^x-]{0,24}") {
        if let Ok(class) = PathClass::new(&text) {
            prop_assert!(!class.layer().contains('.'));
        }
    }

    /// A path's own string is a pattern that has this path, and no other of its length.
    #[test]
    fn a_string_has_its_own_path(path in "[DGS]{0,12}", other in "[DGS]{0,12}") {
        let class = class(&format!("E{path}L"));
        prop_assert!(class.has(&letters(&path)));
        prop_assert_eq!(class.has(&letters(&other)), path == other);
    }
}
