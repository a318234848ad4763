use super::*;
use crate::film::Film;
use crate::reference::film::{FilmPixel, film_sample};
use crate::reference::math::vec3;
use proptest::prelude::*;

const PIXELS: usize = 3;

/// Sample `index` of a pixel: a multiple of 2⁻³² of up to 24 bits, uneven like fireflies; every eleventh of pixel 0 is
/// broken.
fn sample(pixel: usize, index: u32) -> Vec3<f32> {
    // Splitmix64: Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, 2014.
    let mixed = |channel: u64| {
        let mut z = (u64::from(index) << 8 | (pixel as u64) << 2 | channel)
            .wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    };
    let word = |channel| {
        let z = mixed(channel);
        ((z >> 40 << (z & 31)) as f32) * 2f32.powi(-32)
    };
    match (pixel, index % 11) {
        (0, 10) => vec3(f32::NAN, 0.0, 0.0),
        _ => vec3(word(0), word(1), 0.25),
    }
}

/// Like a renderer: samples `range` in slices that end at `slices`, among others.
fn grown(range: Range<u32>, keeps: Keeps, slices: &[u32]) -> Part<f32> {
    let mut part = Part::new([PIXELS as u32, 1], keeps, range.start);
    let mut film = vec![FilmPixel::default(); PIXELS];
    let mut beside = Beside::zero(keeps, PIXELS);
    let sums = |film: &[FilmPixel<f32>], beside: &Beside<f32>| Sums {
        samples: film[0].samples,
        pixels: film.iter().map(PixelSums::from).collect(),
        beside: beside.clone(),
    };
    let mut done = range.start;
    while done < range.end {
        let next = slices.iter().copied().filter(|&s| s > done).min();
        let stop = part.stop(done, next.unwrap_or(range.end).min(range.end));
        for (i, pixel) in film.iter_mut().enumerate() {
            for index in done..stop {
                film_sample(pixel, sample(i, index));
                beside.at(i).add(sample(i, index), pixel.samples);
            }
        }
        done = stop;
        if part.ends_at(done) {
            part.close(sums(&film, &beside));
            film.fill(Default::default());
            beside.clear();
        }
    }
    part.with_tail(sums(&film, &beside))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, rng_seed: proptest::test_runner::RngSeed::Fixed(18), ..ProptestConfig::default() })]

    /// However samples are divided and sliced, the parts join to the part of one rendering.
    #[test]
    fn parts_join_to_the_part_of_one_rendering(
        begin in 0u32..1400,
        lengths in prop::collection::vec(prop_oneof![0u32..20, 0u32..700, Just(256u32), Just(512)], 1..6),
        slices in prop::collection::vec(0u32..4000, 0..8),
        keeps in prop_oneof![Just(Keeps::Nothing), Just(Keeps::Moments), Just(Keeps::Quarters)],
    ) {
        let end = begin + lengths.iter().sum::<u32>();
        let one = grown(begin..end, keeps, &[]);
        let mut joined = grown(begin..begin, keeps, &[]);
        let mut at = begin;
        for length in lengths {
            let part = grown(at..at + length, keeps, &slices);
            let layout = part.layout();
            prop_assert_eq!(part.head.len() as u32, layout.head);
            prop_assert_eq!(part.nodes.iter().map(|n| n.samples).collect::<Vec<_>>(), layout.nodes);
            prop_assert_eq!(part.tail.as_ref().map_or(0, |t| t.samples), layout.tail);
            joined.append(part, &mut |_| {}).expect("the next part");
            at += length;
        }
        prop_assert_eq!(&joined, &one);
        if end > begin {
            prop_assert_eq!(joined.picture(), one.picture());
        }
    }
}

#[test]
fn a_joined_sum_is_exact_to_its_bound() {
    let n = 5000;
    let part = grown(0..n, Keeps::Nothing, &[]);
    for pixel in 1..PIXELS {
        let exact: f64 = (0..n).map(|i| f64::from(sample(pixel, i).x)).sum();
        let mean = f64::from(part.picture().rgb[pixel][0]);
        // One rounding of the sum and one of the division, and n additions of 3·2⁻⁴⁸.
        let bound = 2f64.powi(-23) + f64::from(n) * 3.0 * 2f64.powi(-48);
        assert!(
            (mean * f64::from(n) / exact - 1.0).abs() <= bound,
            "{mean} of {exact}"
        );
    }
}

/// Compared with the two-pass formula in f64.
#[test]
fn standard_errors_and_halves_are_those_of_the_samples() {
    let n = 1337;
    for keeps in [Keeps::Moments, Keeps::Nothing] {
        let part = grown(0..n, keeps, &[]);
        let all: Vec<f64> = (0..n).map(|i| f64::from(sample(1, i).x)).collect();
        let count = f64::from(n);
        let mean = all.iter().sum::<f64>() / count;
        let spread: f64 = all.iter().map(|x| (x - mean).powi(2)).sum();
        let signed = |(i, x): (usize, &f64)| if i % 2 == 0 { *x } else { -x };
        let contrast: f64 = all.iter().enumerate().map(signed).sum();
        let half = (contrast - mean) / (count * count - 1.0).sqrt();
        let expected = match keeps {
            Keeps::Moments => (spread / (count * (count - 1.0))).sqrt(),
            _ => half.abs(),
        };
        let found = f64::from(part.standard_errors().rgb[1][0]);
        assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
        let found = f64::from(part.halves().half_difference.rgb[1][0]);
        assert!((found / half - 1.0).abs() < 1e-4, "{found} {half}");
    }
}

/// Compared with means in f64, for numbers of samples with every remainder, in one block and in many.
#[test]
fn quarters_are_the_means_of_their_samples() {
    for n in [4, 5, 6, 7, 255, 256, 257, 1030, 1337] {
        let part = grown(0..n, Keeps::Quarters, &[]);
        let halves = part.quartered().expect("four samples");
        let mean = |step, first| {
            let all: Vec<f64> = (0..n)
                .filter(|i| i % step == first)
                .map(|i| f64::from(sample(1, i).x))
                .collect();
            all.iter().sum::<f64>() / all.len() as f64
        };
        // Each step of two differences in f32 rounds a value of at most the sum of all: 2 n 2⁻²⁴ of it.
        let sum = f64::from(n) * mean(1, 0);
        let near = |film: &Film, expected: f64, samples: u32| {
            let bound = 2.0 * f64::from(n) * 2f64.powi(-24) * sum / f64::from(samples);
            (f64::from(film.rgb[1][0]) - expected).abs() <= bound
        };
        for (first, half) in (0..).zip(&halves) {
            let least = n / 4;
            assert!(near(&half.mean, mean(2, first), 2 * least), "{n}");
            // The last sample determines their order.
            let [a, b] = &half.quarters;
            let [one, two] = [mean(4, first), mean(4, first + 2)];
            let right = |a, b| near(a, one, least) && near(b, two, least);
            assert!(right(a, b) || right(b, a), "{n}: not {one} and {two}");
            // Shows that the test can fail.
            let other = [mean(4, 1 - first), mean(4, 3 - first)];
            assert!(!other.iter().any(|&x| near(a, x, least)), "{n}");
        }
    }
}

#[test]
fn quarters_need_sums_and_samples_of_their_own() {
    assert!(grown(0..3, Keeps::Quarters, &[]).quartered().is_none());
    assert!(grown(2..40, Keeps::Quarters, &[]).quartered().is_none());
    assert!(grown(8..40, Keeps::Quarters, &[]).quartered().is_some());
    assert!(grown(0..40, Keeps::Moments, &[]).quartered().is_none());
}

#[test]
fn equal_samples_have_no_spread() {
    let mut sums = Sums::zero(1, Keeps::Moments);
    let mut part = Part::new([1, 1], Keeps::Moments, 0);
    for _ in 0..3 * BLOCK {
        sums.add(&[vec3(0.1f32, 0.7, 3.0)]);
        if sums.samples == BLOCK {
            part.close(std::mem::replace(&mut sums, Sums::zero(1, Keeps::Moments)));
        }
    }
    assert_eq!(part.standard_errors().rgb, [[0.0; 3]]);
}

#[test]
fn parts_that_do_not_follow_are_refused() {
    let part = |range| grown(range, Keeps::Nothing, &[]);
    let refused = |next| part(0..10).append(next, &mut |_| {});
    assert_eq!(refused(part(10..12)), Ok(()));
    assert_eq!(refused(part(11..12)), Err(Misfit::Range(11..12, 0..10)));
    for keeps in [Keeps::Moments, Keeps::Quarters] {
        assert_eq!(refused(grown(10..12, keeps, &[])), Err(Misfit::Keeps));
    }
    let other = Part::new([1, 2], Keeps::Nothing, 10);
    assert_eq!(refused(other), Err(Misfit::Size([1, 2], [3, 1])));
    let mut any = AnyPart::F32(part(0..10));
    let wide = AnyPart::F64(Part::new([3, 1], Keeps::Nothing, 10));
    assert_eq!(any.append(wide, &mut |_, _| {}), Err(Misfit::Scalar));
}

/// For any division into parts, the error can be inspected after the same numbers of samples as in one rendering.
#[test]
fn parts_stop_at_powers_of_two() {
    for ranges in [
        &[0..100, 100..3000][..],
        &[0..256, 256..700, 700..1030, 1030..5000],
    ] {
        let mut seen = Vec::new();
        let mut whole = grown(0..0, Keeps::Nothing, &[]);
        for range in ranges {
            let part = grown(range.clone(), Keeps::Nothing, &[]);
            whole
                .append(part, &mut |p| seen.push(p.samples()))
                .expect("the next");
        }
        let first = ranges[0].end;
        let powers = (0..).map(|k| 1 << k).skip_while(|&n| n <= first);
        for power in powers.take_while(|&n| n < whole.samples()) {
            assert!(seen.contains(&power), "{power} of {ranges:?}");
        }
    }
}

#[test]
fn the_largest_sample_is_the_first_of_equals() {
    let largest = |pixel, index, radiance| Tally {
        largest: Some(crate::sample::Largest {
            address: crate::sample::Address { pixel, index },
            radiance,
        }),
        ..Tally::default()
    };
    let of = |a: Tally, b| {
        a.plus(b)
            .largest
            .map(|l| (l.address.pixel, l.address.index))
    };
    assert_eq!(
        of(largest([1, 0], 3, 2.0), largest([1, 0], 9, 2.0)),
        Some(([1, 0], 3))
    );
    assert_eq!(
        of(largest([1, 0], 3, 2.0), largest([0, 0], 9, 2.0)),
        Some(([0, 0], 9))
    );
    assert_eq!(
        of(largest([1, 0], 3, 2.0), largest([1, 1], 9, 2.5)),
        Some(([1, 1], 9))
    );
    assert_eq!(
        of(Tally::default(), largest([1, 1], 9, 2.5)),
        Some(([1, 1], 9))
    );
}
