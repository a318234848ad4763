//! Twins of `shaders/sampler/`.

use vkpt::reference::sampler::owen::owen_scramble;
use vkpt::reference::sampler::pcg4d::{mix_words, pcg4d};
use vkpt::reference::sampler::sobol_digits::{sobol_digits_1, sobol_digits_2, sobol_digits_3};
use vkpt::reference::sampler::{
    bsdf_block, camera_block, chance, light_block, random, roulette_block, sobol, sobol_groups,
    sobol_quarters, unit_float,
};

use super::harness::{In, Row, Twin};

pub fn twins() -> Vec<Twin> {
    [numbers(), scrambling(), blocks()]
        .into_iter()
        .flatten()
        .collect()
}

fn words(i: &mut In) -> [u32; 4] {
    [i.u(), i.u(), i.u(), i.u()]
}

/// A function of four words to four words.
fn hash(name: &'static str, file: &'static str, call: &str, f: fn([u32; 4]) -> [u32; 4]) -> Twin {
    Twin::new(name, file)
        .glsl(&format!(
            "uint x = in_u(); uint y = in_u(); uint z = in_u(); uint w = in_u();
             uvec4 h = {call}; out_u(h.x); out_u(h.y); out_u(h.z); out_u(h.w);"
        ))
        .rust(move |i, o| f(words(i)).into_iter().for_each(|x| o.u(x)))
        .edge([0, 0, 0, 0])
        .edge([u32::MAX; 4])
        .edge([1, 0x8000_0000, 0xffff_0000, 0xffff])
        .seeded(2000, |r| {
            Row::new()
                .u(r.u32())
                .u(r.below(4096))
                .u(r.below(3000))
                .u(r.u32())
        })
}

fn numbers() -> Vec<Twin> {
    vec![
        hash(
            "mix_words",
            "sampler/pcg4d",
            "mix_words(uvec4(x, y, z, w))",
            mix_words,
        ),
        hash("pcg4d", "sampler/pcg4d", "pcg4d(uvec4(x, y, z, w))", pcg4d),
        hash(
            "sampler_block",
            "sampler/random",
            "sampler_block(x, y, z, w)",
            |[p, s, b, e]| random::sampler_block(p, s, b, e),
        ),
        hash(
            "sampler_block",
            "sampler/sobol",
            "sampler_block(x, y, z, w)",
            |[p, s, b, e]| sobol::sampler_block(p, s, b, e),
        )
        // indices at 2²⁴ and at the end of all
        .edges([1 << 24, (1 << 24) - 1, u32::MAX - 1].map(|i| Row::from([7, i, 3, 1]))),
        hash(
            "sampler_block",
            "sampler/sobol_quarters",
            "sampler_block(x, y, z, w)",
            |[p, s, b, e]| sobol_quarters::sampler_block(p, s, b, e),
        ),
        hash(
            "sobol_block",
            "sampler/sobol_groups",
            "sobol_block(x, y, 3u, z, w)",
            |[p, s, b, e]| sobol_groups::sobol_block(p, s, 3, b, e),
        ),
        Twin::new("unit_float", "sampler/unit_float")
            .glsl("out_f(unit_float(in_u()));")
            .rust(|i, o| o.f(unit_float(i.u())))
            .edges(
                [
                    0,
                    255,
                    256,
                    0x7fff_ffff,
                    0x8000_0000,
                    u32::MAX - 256,
                    u32::MAX,
                ]
                .map(|x| Row::from([x])),
            )
            .seeded(2000, |r| Row::new().u(r.u32())),
        Twin::new("chance", "sampler/chance")
            .glsl("out_f(chance(in_f()));")
            .rust(|i, o| o.f(chance(i.f())))
            .edges(
                [
                    0.0,
                    1e-40,
                    2.4414e-4,
                    2.441406e-4,
                    2.4414063e-4,
                    1.0,
                    f32::NAN,
                ]
                .map(|p| Row::new().f(p)),
            )
            .seeded(2000, |r| Row::new().f(r.log_range(1e-12, 1.0))),
    ]
}

/// Digits of Sobol's sequence, and their scrambling.
fn scrambling() -> Vec<Twin> {
    let digits = |name, call: &str, f: fn(u32) -> u32| {
        Twin::new(name, "sampler/sobol_digits")
            .glsl(&format!("uint index = in_u(); out_u({call});"))
            .rust(move |i, o| o.u(f(i.u())))
            .edges((0..32).map(|k| Row::from([1 << k])))
            .edges([0, 1 << 24, u32::MAX].map(|x| Row::from([x])))
            .seeded(2000, |r| Row::new().u(r.u32()))
    };
    vec![
        Twin::new("lowbias32", "sampler/sobol_groups")
            .glsl("out_u(lowbias32(in_u()));")
            .rust(|i, o| o.u(sobol_groups::lowbias32(i.u())))
            .edges([0, 1, 1 << 31, u32::MAX].map(|x| Row::from([x])))
            .seeded(2000, |r| Row::new().u(r.u32())),
        Twin::new("owen_scramble", "sampler/owen")
            .glsl("uint digits = in_u(); out_u(owen_scramble(digits, in_u()));")
            .rust(|i, o| {
                let digits = i.u();
                o.u(owen_scramble(digits, i.u()));
            })
            .edges([[0, 0], [u32::MAX, 0], [0, u32::MAX], [u32::MAX; 2]].map(Row::from))
            .seeded(2000, |r| Row::new().u(r.u32()).u(r.u32())),
        digits("sobol_digits_1", "sobol_digits_1(index)", sobol_digits_1),
        digits("sobol_digits_2", "sobol_digits_2(index)", sobol_digits_2),
        digits("sobol_digits_3", "sobol_digits_3(index)", sobol_digits_3),
    ]
}

fn blocks() -> Vec<Twin> {
    let block = |name, call: &str, f: fn(u32) -> u32| {
        Twin::new(name, "sampler/dimensions")
            .glsl(&format!("uint bounce = in_u(); out_u({call});"))
            .rust(move |i, o| o.u(f(i.u())))
            .edges([0, 1, 2, 999, 1_000_000].map(|b| Row::from([b])))
    };
    vec![
        block("camera_block", "camera_block()", |_| camera_block()),
        block("light_block", "light_block(bounce)", light_block),
        block("bsdf_block", "bsdf_block(bounce)", bsdf_block),
        block("roulette_block", "roulette_block(bounce)", roulette_block),
    ]
}
