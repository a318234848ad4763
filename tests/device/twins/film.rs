//! Twins of `shaders/film/`.

use vkpt::layout::GpuStruct;
use vkpt::reference::film::{
    FilmMoments, FilmPixel, FilmQuarters, PixelSum, film_add, film_mean, film_moments,
    film_quarters, film_sample,
};
use vkpt::reference::math::{Vec3, vec3};

use super::harness::{Rng, Row, Twin};

const GLSL: &str = "vec3 sum = in_vec3(); PixelSum pixel = PixelSum(sum, in_vec3());";

/// A sum in two parts as additions leave it: `comp` below half a unit of `sum`.
fn sum(r: &mut Rng) -> Row {
    let whole = vec3(
        r.log_range(1e-6, 1e12),
        r.unit(),
        16_777_216.0 + r.below(9) as f32,
    );
    let mut rest = |x: f32| x * r.range(-2f32.powi(-26), 2f32.powi(-26));
    let rest = vec3(rest(whole.x), rest(whole.y), rest(whole.z));
    Row::new().vec3(whole).vec3(rest)
}

pub fn twins() -> Vec<Twin> {
    let at_two_to_the_24 = || {
        Row::new()
            .vec3(Vec3::splat(16_777_216.0))
            .vec3(vec3(0.0, 1.0, -0.5))
    };
    let zero = || Row::new().vec3(Vec3::zero()).vec3(Vec3::zero());
    vec![
        Twin::new("film_add", "film/pixel_sum")
            .glsl(&format!(
                "{GLSL} PixelSum after = film_add(pixel, in_vec3());
                 out_vec3(after.sum); out_vec3(after.comp);"
            ))
            .rust(|i, o| {
                let pixel = PixelSum {
                    sum: i.vec3(),
                    comp: i.vec3(),
                };
                let after = film_add(pixel, i.vec3());
                o.vec3(after.sum);
                o.vec3(after.comp);
            })
            .edge(zero().vec3(Vec3::zero()))
            .edge(zero().vec3(vec3(1e-45, 1.0, 3e38)))
            .edge(at_two_to_the_24().vec3(Vec3::one()))
            .seeded(5000, |r| {
                sum(r).vec3(vec3(r.unit(), r.log_range(1e-9, 1e9), r.range(0.0, 4.0)))
            }),
        Twin::new("film_mean", "film/pixel_sum")
            .glsl(&format!("{GLSL} out_vec3(film_mean(pixel, in_u()));"))
            .rust(|i, o| {
                let pixel = PixelSum {
                    sum: i.vec3(),
                    comp: i.vec3(),
                };
                o.vec3(film_mean(pixel, i.u()));
            })
            .edge(zero().u(1))
            // a number of samples that f32 rounds: to even, and up
            .edge(at_two_to_the_24().u((1 << 24) + 1))
            .edge(at_two_to_the_24().u((1 << 24) + 3))
            .edge(at_two_to_the_24().u(u32::MAX))
            .seeded(2000, |r| sum(r).u((r.u32() >> r.below(32)).max(1))),
        dropping(),
        moments(),
        quarters(),
    ]
}

/// Good samples, and broken ones, which count as 0.
fn dropping() -> Twin {
    let row = |x: f32| Row::new().vec3(vec3(1.0, x, 2.0)).u(7);
    Twin::new("film_sample", "film/film_pixel")
        .also(&["has_nan", "is_summable"])
        .prelude(vkpt::layout::FilmPixel::glsl())
        .glsl(
            "vec3 radiance = in_vec3();
             FilmPixel pixel = FilmPixel(vec3(1.0), in_u(), vec3(0.0), 0u, 1u, 2u, 0u, 0u, vec3(0.75), 0u, 1.5, 3u, 0u, 0u);
             film_sample(pixel, radiance);
             out_vec3(pixel.sum); out_vec3(pixel.comp); out_vec3(pixel.contrast);
             out_u(pixel.samples); out_u(pixel.nan); out_u(pixel.infinite);
             out_f(pixel.largest); out_u(pixel.largest_sample);",
        )
        .rust(|i, o| {
            let sum = PixelSum { sum: Vec3::one(), comp: Vec3::zero() };
            let radiance = i.vec3();
            let contrast = Vec3::splat(0.75);
            let mut pixel = FilmPixel { sum, samples: i.u(), nan: 1, infinite: 2, contrast, largest: 1.5, largest_sample: 3, ..FilmPixel::default() };
            film_sample(&mut pixel, radiance);
            o.vec3(pixel.sum.sum);
            o.vec3(pixel.sum.comp);
            o.vec3(pixel.contrast);
            o.u(pixel.samples);
            o.u(pixel.nan as u32);
            o.u(pixel.infinite as u32);
            o.f(pixel.largest);
            o.u(pixel.largest_sample);
        })
        .edges([0.0, 1e-45, f32::MAX, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, -f32::NAN].map(row))
        // 2⁹⁶ and the next number below
        .edges([0x6f80_0000, 0x6f7f_ffff, 0xef80_0000].map(|bits| row(f32::from_bits(bits))))
        // the largest so far, once more, and the next number above
        .edges([0x3fc0_0000, 0x3fc0_0001].map(|bits| Row::new().vec3(vec3(0.0, 1.0, f32::from_bits(bits))).u(6)))
        .edge(Row::new().vec3(vec3(f32::INFINITY, f32::NAN, f32::NEG_INFINITY)).u(6))
        .edge(Row::new().vec3(vec3(f32::INFINITY, f32::NEG_INFINITY, 1.0)).u(6))
        .seeded(1000, |r| Row::new().u(r.u32()).u(r.u32()).u(r.u32()).u(r.u32() >> 1))
}

/// A mean and a sum of squares, each in two parts, and one more sample.
fn quarters() -> Twin {
    Twin::new("film_quarters", "film/film_quarters")
        .prelude(vkpt::layout::FilmQuarters::glsl())
        .glsl(
            "vec3 even = in_vec3(); FilmQuarters quarters = FilmQuarters(even, 0u, in_vec3(), 0u);
             vec3 radiance = in_vec3();
             film_quarters(quarters, radiance, in_u());
             out_vec3(quarters.even); out_vec3(quarters.odd);",
        )
        .rust(|i, o| {
            let (even, odd) = (i.vec3(), i.vec3());
            let mut quarters = FilmQuarters { even, odd };
            film_quarters(&mut quarters, i.vec3(), i.u());
            o.vec3(quarters.even);
            o.vec3(quarters.odd);
        })
        .edges([1, 2].map(|n| {
            let broken = vec3(1.0, f32::NAN, 2.0);
            Row::new()
                .vec3(vec3(3.0, -2.0, 0.5))
                .vec3(Vec3::one())
                .vec3(broken)
                .u(n)
        }))
        .seeded(2000, |r| {
            let v = |r: &mut Rng| vec3(r.log_range(1e-6, 1e12), r.unit(), r.log_range(0.1, 10.0));
            Row::new().vec3(v(r)).vec3(v(r)).vec3(v(r)).u(r.below(5000))
        })
}

fn moments() -> Twin {
    let seen = |r: &mut Rng| Row(sum(r).0.into_iter().chain(sum(r).0).collect());
    let still = || {
        Row::new()
            .vec3(Vec3::one())
            .vec3(Vec3::zero())
            .vec3(Vec3::zero())
            .vec3(Vec3::zero())
    };
    let none = || Row([0; 12].into());
    Twin::new("film_moments", "film/film_moments")
        .prelude(vkpt::layout::FilmMoments::glsl())
        .glsl(
            "vec3 mean = in_vec3(); vec3 mean_comp = in_vec3(); vec3 m2 = in_vec3(); vec3 m2_comp = in_vec3();
             FilmMoments moments = FilmMoments(mean, 0u, mean_comp, 0u, m2, 0u, m2_comp, 0u);
             vec3 radiance = in_vec3();
             film_moments(moments, radiance, in_u());
             out_vec3(moments.mean); out_vec3(moments.mean_comp); out_vec3(moments.m2); out_vec3(moments.m2_comp);",
        )
        .rust(|i, o| {
            let mut sum = || PixelSum { sum: i.vec3(), comp: i.vec3() };
            let (mean, m2) = (sum(), sum());
            let mut moments = FilmMoments { mean, m2 };
            film_moments(&mut moments, i.vec3(), i.u());
            for PixelSum { sum, comp } in [moments.mean, moments.m2] {
                o.vec3(sum);
                o.vec3(comp);
            }
        })
        .edge(none().vec3(vec3(0.0, 1e-45, 3e38)).u(1))
        .edge(none().vec3(vec3(f32::NAN, 1.0, 2.0)).u(1))
        .edge(still().vec3(Vec3::one()).u(2))
        .edge(still().vec3(vec3(1.0, f32::INFINITY, 1.0)).u(3))
        .edge(still().vec3(vec3(2.0, 0.0, 1.0 + f32::EPSILON)).u((1 << 24) + 1))
        .edge(still().vec3(Vec3::zero()).u(u32::MAX))
        .seeded(5000, |r| {
            let n = (r.u32() >> r.below(32)).max(1);
            seen(r)
                .vec3(vec3(r.log_range(1e-9, 1e9), r.unit(), 16_777_216.0 + r.below(9) as f32))
                .u(n)
        })
}
