//! Any file is read or refused: never a panic, and never a value that is not a number.
//!
//! Without optimisation exr 1.74 panics on some broken B44 data (it relies on wrapping); `decode` makes that a refusal,
//! but the panic's own words are seen in this test's output.

use std::path::Path;

use vkpt::image::{Format, decode};

use super::films::{encoded, film};

/// SplitMix64 (Steele, Lea, Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Below `n`, which is above 0.
    fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
}

/// Small pictures of every kind: vkpt's own and other programs'.
fn seeds() -> Vec<Vec<u8>> {
    let own = [Format::Exr, Format::Hdr, Format::Png].map(|f| encoded(&film(), f, 0.0));
    let mut paths: Vec<_> = std::fs::read_dir(Path::new("tests/data/image"))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e != "py"))
        .collect();
    paths.sort();
    let others = paths
        .iter()
        .map(|path| std::fs::read(path).expect("a file"));
    own.into_iter().chain(others).collect()
}

fn mutate(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len());
    match random.below(6) {
        0 => bytes.truncate(at.max(1)),
        1 => bytes[at] ^= 1 << random.below(8),
        2 => bytes[at] = random.next() as u8,
        // Counts and sizes are words: large, and negative.
        3 => {
            let word = [u32::MAX, i32::MAX as u32, 0, 1 << 30][random.below(4)].to_le_bytes();
            let end = bytes.len().min(at + 4);
            bytes[at..end].copy_from_slice(&word[..end - at]);
        }
        // Most of the important bytes are in the header.
        4 => {
            let at = random.below(bytes.len().min(400));
            bytes[at] = random.next() as u8;
        }
        _ if bytes.len() > 1 => drop(bytes.remove(at)),
        _ => {}
    }
}

/// Mutates each seed `rounds` times, up to three changes at once, and returns how many were still read.
fn fuzz(rounds: usize, seed: u64) -> usize {
    let mut random = Random(seed);
    let mut read = 0;
    for original in seeds() {
        for _ in 0..rounds {
            let mut bytes = original.clone();
            for _ in 0..=random.below(3) {
                mutate(&mut bytes, &mut random);
            }
            match decode(&bytes) {
                Ok(picture) => {
                    let [w, h] = [picture.film.width, picture.film.height].map(|n| n as usize);
                    assert_eq!(picture.film.rgb.len(), w * h);
                    assert!(
                        picture
                            .film
                            .rgb
                            .as_flattened()
                            .iter()
                            .all(|v| v.is_finite())
                    );
                    read += 1;
                }
                Err(error) => {
                    assert!(!error.to_string().is_empty());
                }
            }
        }
    }
    read
}

#[test]
fn broken_pictures_are_refused() {
    let read = fuzz(60, 3);
    // Not every change is seen: pixels without checksums, names, comments.
    assert!(read > 100, "{read}");
}

#[test]
fn no_beginning_is_a_picture() {
    for bytes in seeds() {
        if decode(&bytes).is_err() {
            continue;
        }
        for length in 0..bytes.len() {
            assert!(
                decode(&bytes[..length]).is_err(),
                "{length} of {}",
                bytes.len()
            );
        }
    }
}

#[test]
#[ignore = "half a minute: the same with many more rounds"]
fn broken_pictures_are_refused_many() {
    fuzz(5_000, 5);
}
