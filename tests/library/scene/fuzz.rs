//! Any file is read or refused: never a panic, and never a scene that breaks a promise.

use std::path::Path;

use vkpt::scene::parse;

use crate::bodies;

/// SplitMix64 (Steele, Lea, Flood 2014).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Below `n`, which is above 0.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
}

const VALID: &str = "# a scene\nscreen 40 30\ncamera 5.5 2.9 2.9 0.2 q 0.4 0.3 0.5 0.7\nambient .1 .1 .1\n\
    background 0.1 0.2 0.3\nlight 5 5 5\nsphere 1.9 5 2 2\nbrdf .6 .6 .6 .03 .03 .03 10 0 0 0 1.0\n\
    box -3 -3 -.1 18 18 .1\ndistribution beckmann\nfresnel exact\n\tbrdf 0 0 0 .04 .04 .04 .3 .9 .5 1 1.5\r\n\
    cylinder 1 1 0 0 0 .4 .05\nmesh tests/data/scene/tetrahedron.ply 0 0 1 .5 x 90 a 20 1 0 1\n";

/// Tokens that are likely to hurt.
pub const NASTY: [&str; 24] = [
    "nan", "inf", "-inf", "1e999", "-1e999", "1e-999", "-0", "0", "-1", "1e38", "4e38", "1e-45",
    "1e-46", "9e99x", "", "q", "x", "a", "#", "mesh", "é", "\u{202e}", "\u{7}", "0x1p3",
];

#[test]
fn the_valid_scene_is_valid() {
    let read = parse(VALID, Path::new("fuzz.scn"), true).expect("a legal scene");
    assert_eq!(read.scene.shapes.len(), 4);
}

#[test]
fn random_bytes_never_panic() {
    let mut random = Random(7);
    for _ in 0..400 {
        let length = random.below(300);
        let bytes: Vec<u8> = (0..length).map(|_| random.next() as u8).collect();
        bodies::scene(&bytes);
    }
}

#[test]
fn mutated_scenes_never_panic_and_keep_their_promises() {
    let mut random = Random(11);
    for _ in 0..4000 {
        let mut text = VALID.to_owned();
        for _ in 0..=random.below(3) {
            text = mutate(&text, &mut random);
        }
        bodies::scene(text.as_bytes());
    }
}

fn mutate(text: &str, random: &mut Random) -> String {
    match random.below(4) {
        // A token gives way to a nasty one, or is lost.
        0 | 1 => {
            let tokens: Vec<_> = text.split_inclusive([' ', '\n']).collect();
            let at = random.below(tokens.len());
            let nasty = format!("{} ", NASTY[random.below(NASTY.len())]);
            let swap = |(i, token): (usize, &&str)| {
                if i == at {
                    nasty.clone()
                } else {
                    (*token).to_owned()
                }
            };
            tokens.iter().enumerate().map(swap).collect()
        }
        // Two lines change places.
        2 => {
            let mut lines: Vec<_> = text.lines().collect();
            let (a, b) = (random.below(lines.len()), random.below(lines.len()));
            lines.swap(a, b);
            lines.join("\n")
        }
        // A byte changes.
        _ => {
            let mut bytes = text.as_bytes().to_vec();
            let at = random.below(bytes.len());
            bytes[at] = random.next() as u8;
            String::from_utf8_lossy(&bytes).into_owned()
        }
    }
}
