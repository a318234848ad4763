//! Non-local means: noise goes, edges stay, and brightness.

use vkpt::denoise::{Features, nlm};
use vkpt::film::Film;

use crate::metrics::pictures::{Random, constant, film, mapped};

const SIZE: [u32; 2] = [48, 40];

/// The picture of `pixel(x, y)`.
fn of(pixel: impl Fn(u32, u32) -> [f32; 3]) -> Film {
    film(SIZE[0], SIZE[1], pixel)
}

/// Surfaces that are all alike.
fn flat() -> Features {
    Features {
        albedo: constant(SIZE[0], SIZE[1], [0.5; 3]),
        normal: constant(SIZE[0], SIZE[1], [0.0, 0.0, 1.0]),
    }
}

/// Mean square of the differences.
fn mse(a: &Film, b: &Film) -> f64 {
    let values = a.rgb.as_flattened().iter().zip(b.rgb.as_flattened());
    let squares = values.map(|(&a, &b)| f64::from(a - b).powi(2));
    squares.sum::<f64>() / a.rgb.as_flattened().len() as f64
}

/// Two halves with noise of standard deviation `s`, denoised; and the mean of the halves.
fn denoised(truth: &Film, s: f32, features: &Features, seed: u64) -> [Film; 2] {
    let mut random = Random(seed);
    let spread = constant(SIZE[0], SIZE[1], [s; 3]);
    let [a, b] = [(); 2].map(|()| random.noisy(truth, &spread));
    let mean = of(|x, y| {
        let i = (y * SIZE[0] + x) as usize;
        [0, 1, 2].map(|c| (a.rgb[i][c] + b.rgb[i][c]) / 2.0)
    });
    [nlm([&a, &b], features), mean]
}

/// Most of the noise of 17² equal pixels is removed, except at pixels near an edge or unlike the others by chance.
#[test]
fn noise_of_a_plain_wall_goes_and_its_brightness_stays() {
    let truth = constant(SIZE[0], SIZE[1], [1.0, 0.3, 2.0]);
    let [clean, noisy] = denoised(&truth, 0.2, &flat(), 5);
    let share = mse(&clean, &truth) / mse(&noisy, &truth);
    assert!(share < 1.0 / 40.0, "{share}");
    let mean = |film: &Film| film.rgb.as_flattened().iter().sum::<f32>();
    assert!((mean(&clean) / mean(&noisy) - 1.0).abs() < 0.005);
}

/// An edge of radiance stays where it is far above the noise; one within the noise stays where surfaces show it.
#[test]
fn edges_stay() {
    let edge = |low: f32, high: f32| of(move |x, _| [if x < 24 { low } else { high }; 3]);
    let [clean, _] = denoised(&edge(0.5, 2.0), 0.1, &flat(), 6);
    let step = |film: &Film| film.rgb[20 * 48 + 24][0] - film.rgb[20 * 48 + 23][0];
    assert!((step(&clean) - 1.5).abs() < 0.1, "{}", step(&clean));
    let faint = edge(1.0, 1.1);
    let features = Features {
        albedo: mapped(&faint, |x| 5.0 * (x - 1.0)),
        ..flat()
    };
    let [blurred, _] = denoised(&faint, 0.3, &flat(), 7);
    let [kept, _] = denoised(&faint, 0.3, &features, 7);
    let errors = [&blurred, &kept].map(|film| mse(film, &faint));
    assert!(errors[1] < errors[0] / 2.0, "{errors:?}");
}

/// A picture without noise is one of edges: none of it changes by more than the limit of equal values.
#[test]
fn a_picture_without_noise_stays() {
    let truth = of(|x, y| [0.1 + (x * 7 + y * 13) as f32 % 10.0, 1.0, x as f32 / 8.0]);
    let clean = nlm([&truth, &truth], &flat());
    assert!(mse(&clean, &truth) < 1e-4, "{}", mse(&clean, &truth));
}

/// A firefly in one half has no part in the weights by which it is spread.
#[test]
fn a_firefly_is_spread_over_its_like() {
    let truth = constant(SIZE[0], SIZE[1], [1.0; 3]);
    let mut random = Random(8);
    let spread = constant(SIZE[0], SIZE[1], [0.1; 3]);
    let [mut a, b] = [(); 2].map(|()| random.noisy(&truth, &spread));
    a.rgb[20 * 48 + 24] = [500.0; 3];
    let clean = nlm([&a, &b], &flat());
    let most = clean.rgb.as_flattened().iter().copied().fold(0.0, f32::max);
    // 500 over two halves and some two hundred pixels.
    assert!(most < 10.0, "{most}");
}

#[test]
fn the_bits_do_not_depend_on_the_number_of_threads() {
    let truth = of(|x, y| [x as f32 / 48.0, y as f32 / 40.0, 1.0]);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads")
            .install(|| denoised(&truth, 0.2, &flat(), 9))
    };
    assert!(on(1) == on(5));
}
