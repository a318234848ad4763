//! Parts in files: read back as they were written, or refused.

use std::fs;
use std::path::{Path, PathBuf};

use vkpt::part::AnyPart;
use vkpt::state::{Header, Kept, StateError, differs, parse, read, read_header, write};

/// Files that vkpt wrote: the format stays readable, or gets another version.
const KEPT: [&str; 21] = [
    "bidirectional",
    "block",
    "block-and-one",
    "crop",
    "from-the-second",
    "head-alone",
    "head-and-tail",
    "head-node-tail",
    "head-to-the-end",
    "light",
    "moments",
    "moments-and-head",
    "one",
    "second-block",
    "seed",
    "three-blocks",
    "two",
    "two-blocks",
    "whole",
    "wide",
    "wide-head",
];

fn path(name: &str) -> PathBuf {
    Path::new("fuzz/corpus/part").join(name)
}

fn bytes(name: &str) -> Vec<u8> {
    fs::read(path(name)).expect("a file")
}

fn kept(name: &str) -> Kept {
    parse(&bytes(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn kept_files_are_read_and_written_again() {
    for name in KEPT {
        let Kept { header, part } = kept(name);
        let mut again = Vec::new();
        write(&mut again, &header, &part).expect("a vector takes anything");
        let twice = parse(&again).expect("what was written");
        assert!(twice.part == part, "{name}");
        assert_eq!(differs(&twice.header, &header), None, "{name}");
        let from_disk = read(&path(name)).expect("a part");
        assert!(from_disk.part == part, "{name}");
        let (header, samples, keeps) = read_header(&path(name)).expect("a header");
        assert_eq!(samples, [part.range().start, part.range().end], "{name}");
        assert_eq!(keeps, part.keeps(), "{name}");
        assert_eq!(header.record.job.spp, part.samples(), "{name}");
        let wide = matches!(part, AnyPart::F64(_));
        assert_eq!(wide, name.starts_with("wide"), "{name}");
    }
}

/// Every bit and every length.
#[test]
fn a_damaged_file_is_refused() {
    for name in ["two", "moments-and-head"] {
        let whole = bytes(name);
        assert!(parse(&whole).is_ok());
        for bit in 0..8 * whole.len() {
            let mut bytes = whole.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert!(parse(&bytes).is_err(), "{name}: bit {bit}");
        }
        for length in 0..whole.len() {
            assert!(parse(&whole[..length]).is_err(), "{name}: {length} bytes");
        }
        assert!(
            parse(&[&whole[..], &[0]].concat()).is_err(),
            "one byte more"
        );
    }
}

#[test]
fn a_refusal_says_why() {
    let refused = |bytes: &[u8]| parse(bytes).expect_err("refused");
    assert!(matches!(refused(b""), StateError::Foreign));
    assert!(matches!(refused(b"v/1\n\x01\x00\x00"), StateError::Foreign));
    assert!(matches!(
        refused(&bytes("version-two")),
        StateError::Version(2, 1)
    ));
    assert!(matches!(
        refused(&bytes("endless-header")),
        StateError::Header(_)
    ));
    assert!(matches!(
        refused(&bytes("backwards")),
        StateError::Header(_)
    ));
    assert!(matches!(
        refused(&bytes("another-area")),
        StateError::Header(_)
    ));
    assert!(matches!(
        refused(&bytes("cut-at-the-end")),
        StateError::Length { .. }
    ));
    let mut damaged = bytes("two");
    let end = damaged.len() - 40;
    damaged[end] ^= 1;
    assert!(matches!(refused(&damaged), StateError::Checksum));
    let folder = read(Path::new("fuzz")).expect_err("a folder");
    assert_eq!(folder.to_string(), "it is not a regular file");
}

/// A file that says it has more than there is takes no memory for it.
#[test]
fn a_size_that_is_not_there_is_refused_before_it_is_read() {
    let text = String::from_utf8_lossy(&bytes("two")).into_owned();
    let header = text.split("\"record\"").next().expect("the beginning");
    assert!(header.contains("\"area\":[2,1]"), "{header}");
    let mut bytes = bytes("two");
    let place = header.find("[0,2]").expect("the samples");
    // Samples 0..9: the same length of the file would mean another number of sums, except for the record, which says 2.
    bytes[place + 3] = b'9';
    assert!(matches!(parse(&bytes), Err(StateError::Header(_))));
}

#[test]
fn differences_are_named() {
    let own = kept("two").header;
    let other = |change: &dyn Fn(&mut Header)| {
        let mut other = own.clone();
        change(&mut other);
        differs(&other, &own)
    };
    assert_eq!(other(&|_| {}), None);
    assert_eq!(other(&|h| h.record.seconds.render = 9.0), None);
    assert_eq!(other(&|h| h.record.machine.device = "other".into()), None);
    let named = |change: &dyn Fn(&mut Header), words: &str| {
        let difference = other(change).map(|d| d.between(["a", "b"]));
        assert_eq!(difference.as_deref(), Some(words));
    };
    named(
        &|h| h.digest.clear(),
        "the scene or one of its meshes differs",
    );
    named(
        &|h| h.record.version = "0.0.9".into(),
        "vkpt's version is 0.0.9 in a and 0.1.0 in b",
    );
    named(
        &|h| h.record.job.size = [3, 1],
        "--size is 3x1 in a and 2x1 in b",
    );
    named(
        &|h| h.record.job.crop = Some([0, 0, 1, 1]),
        "--crop is 0,0,1,1 in a and none in b",
    );
    named(&|h| h.record.job.seed = 3, "--seed is 3 in a and 0 in b");
    type Change = fn(&mut Header);
    let settings: [(&str, Change); 12] = [
        ("--fresnel is x in a and scene in b", |h| {
            h.record.job.settings.fresnel = "x".into()
        }),
        ("--distribution is x in a and scene in b", |h| {
            h.record.job.settings.distribution = "x".into()
        }),
        ("--absorption is x in a and segment in b", |h| {
            h.record.job.settings.absorption = "x".into()
        }),
        ("--radiance-scaling is off in a and on in b", |h| {
            h.record.job.settings.radiance_scaling = false
        }),
        ("--max-depth is 3 in a and none in b", |h| {
            h.record.job.settings.max_depth = Some(3)
        }),
        ("--integrator is x in a and path in b", |h| {
            h.record.job.settings.integrator = "x".into()
        }),
        ("--lobe is x in a and fresnel in b", |h| {
            h.record.job.settings.lobe = "x".into()
        }),
        ("--normals is x in a and visible in b", |h| {
            h.record.job.settings.normals = "x".into()
        }),
        ("--roulette is x in a and throughput in b", |h| {
            h.record.job.settings.roulette = "x".into()
        }),
        ("--connect is x in a and mis in b", |h| {
            h.record.job.settings.connect = "x".into()
        }),
        ("--lights is x in a and contribution in b", |h| {
            h.record.job.settings.lights = "x".into()
        }),
        ("--sampler is x in a and sobol in b", |h| {
            h.record.job.settings.sampler = "x".into()
        }),
    ];
    for (words, change) in settings {
        named(&change, words);
    }
}

/// Kept files with bytes of them changed, cut out or put in, under the right checksum.
#[test]
fn changed_bytes_are_whole_or_refused() {
    use proptest::prelude::*;
    use proptest::test_runner::{Config, RngSeed, TestRunner};

    let mut runner = TestRunner::new(Config {
        cases: 3000,
        rng_seed: RngSeed::Fixed(18),
        failure_persistence: None,
        ..Config::default()
    });
    let change = (any::<prop::sample::Index>(), any::<u8>(), 0u8..3);
    let changes = prop::collection::vec(change, 1..4);
    let cases = (prop::sample::select(&KEPT[..]), changes);
    let result = runner.run(&cases, |(name, changes)| {
        let mut bytes = bytes(name);
        for (index, byte, kind) in changes {
            let at = index.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                _ => drop(bytes.remove(at)),
            }
        }
        crate::bodies::part(&bytes);
        Ok(())
    });
    result.expect("no panic");
}
