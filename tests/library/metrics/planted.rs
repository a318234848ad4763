//! Errors that the block z-test should see, and errors that it cannot.

use vkpt::film::Film;

use super::estimates::{measured, test};
use super::pictures::{Random, at, film, mapped};
use crate::common::data::data;

/// A picture of several colours with 5 % of noise, and its errors: as with a few hundred samples.
fn scene() -> [Film; 2] {
    let mean = film(200, 150, |x, y| {
        let (x, y) = (x as f32 / 40.0, y as f32 / 30.0);
        [
            1.0 + 0.5 * x.sin(),
            0.6 + 0.4 * y.cos(),
            0.3 + 0.2 * (x + y).sin(),
        ]
    });
    let stderr = mapped(&mean, |v| 0.05 * v);
    [mean, stderr]
}

#[test]
fn planted_differences_are_found() {
    let [mean, stderr] = scene();
    let mut random = Random(1);
    let reference = random.noisy(&mean, &stderr);
    let image = random.noisy(&mean, &stderr);
    let against =
        |picture: &Film| test(&measured(picture, &stderr), &measured(&reference, &stderr));
    assert!(against(&image).passes());
    let brighter = mapped(&image, |v| 1.01 * v);
    let swapped = film(200, 150, |x, y| {
        let [r, g, b] = at(&image, x, y);
        [b, g, r]
    });
    // A lobe a tenth too strong in one corner: 30×30 pixels of red.
    let lobe = film(200, 150, |x, y| {
        let [r, g, b] = at(&image, x, y);
        [if x < 30 && y < 30 { 1.1 * r } else { r }, g, b]
    });
    for (name, planted) in [("×1.01", &brighter), ("swapped", &swapped), ("lobe", &lobe)] {
        assert!(!against(planted).passes(), "{name}");
    }
    assert_eq!(against(&lobe).worst().origin, [0, 0]);
}

/// A shift by a pixel moves a block's mean by the pixels that enter less those that leave: an edge across it gives 1/25 of its
/// height, a smooth picture next to nothing.
#[test]
fn it_sees_a_shift_where_there_are_edges() {
    let edges = |dx: u32| {
        film(200, 150, move |x, _| {
            if ((x + dx) / 20).is_multiple_of(2) {
                [1.0; 3]
            } else {
                [0.1; 3]
            }
        })
    };
    let [mean, shifted] = [edges(0), edges(1)];
    let stderr = mapped(&mean, |v| 0.05 * v);
    let mut random = Random(2);
    let reference = random.noisy(&mean, &stderr);
    let image = random.noisy(&mean, &stderr);
    let moved = random.noisy(&shifted, &stderr);
    assert!(test(&measured(&image, &stderr), &measured(&reference, &stderr)).passes());
    assert!(!test(&measured(&moved, &stderr), &measured(&reference, &stderr)).passes());
}

/// One sample in a million, black instead of 1: at 256 samples in each of 30,000 pixels, 8 broken samples. The
/// bitwise comparison sees each of them, this test must not.
#[test]
fn it_cannot_see_one_broken_sample_in_a_million() {
    let [mean, stderr] = scene();
    let mut random = Random(3);
    let reference = random.noisy(&mean, &stderr);
    let image = random.noisy(&mean, &stderr);
    let mut broken = image.clone();
    for i in 0..8 {
        broken.rgb[3_749 * i]
            .iter_mut()
            .for_each(|v| *v *= 255.0 / 256.0);
    }
    let against =
        |picture: &Film| test(&measured(picture, &stderr), &measured(&reference, &stderr));
    assert_ne!(broken, image);
    assert!(against(&broken).passes());
    assert!((against(&broken).worst().z - against(&image).worst().z).abs() < 1e-2);
}

/// Noise on a picture of another renderer, of the standard errors that it came with: two such pictures agree, with
/// one of them 1 % brighter they do not.
#[test]
fn it_sees_one_percent_of_a_converged_picture() {
    let read = |name: &str| {
        let path = data("oracle").join(name);
        vkpt::image::read(&path)
            .unwrap_or_else(|e| panic!("{}: {e}", path.display()))
            .film
    };
    let [oracle, stderr] = ["cornell-beer.exr", "cornell-beer-stderr.exr"].map(read);
    let mut random = Random(4);
    let [image, reference] = [0, 1].map(|_| random.noisy(&oracle, &stderr));
    let brighter = mapped(&image, |v| 1.01 * v);
    let against =
        |picture: &Film| test(&measured(picture, &stderr), &measured(&reference, &stderr));
    assert!(against(&image).passes());
    assert!(!against(&brighter).passes());
}
