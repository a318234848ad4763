//! Materials: `brdf`, `light`, and the words `distribution` and `fresnel`.

use glam::DVec3;

use super::arguments::Arguments;
use super::builder::Builder;
use super::commands::closest;
use super::field::{Number, RADIANCE, any, not_negative, positive, share, vector};
use super::log::Log;
use super::number::prefix_length;
use super::text::shorten;
use super::{Brdf, MaterialKind};
use crate::settings::{Distribution, Fresnel};

/// `brdf  Kd(3) Ks(3) alpha` or `brdf  Kd(3) Ks(3) alpha  Kt(3) ior`
pub(super) fn brdf(builder: &mut Builder, arguments: &mut Arguments) {
    let log = &mut builder.log;
    let [k0, k1, k2] = share(["Kd.r", "Kd.g", "Kd.b"], "Kd");
    let [s0, s1, s2] = share(["Ks.r", "Ks.g", "Ks.b"], "Ks");
    let alpha = not_negative("alpha", "alpha");
    let reflection = arguments.numbers(log, [k0, k1, k2, s0, s1, s2, alpha]);
    let Ok(transmission) = transmission(arguments, log) else {
        return;
    };
    let Some([k0, k1, k2, s0, s1, s2, alpha]) = reflection else {
        return;
    };
    let (kd, ks) = (vector(&[k0, k1, k2]), vector(&[s0, s1, s2]));
    let (kt, ior) = match transmission {
        Some([t0, t1, t2, ior]) => (vector(&[t0, t1, t2]), ior.value),
        None => (DVec3::ZERO, 1.0),
    };
    let command = arguments.command().place;
    if kd != DVec3::ZERO && kt != DVec3::ZERO {
        let message = "Kd and Kt are both above 0".into();
        log.warning(command, message, "a material either scatters or transmits")
            .help("the terms are added: the surface may reflect and transmit more light than it receives");
    }
    let brdf = Brdf {
        kd,
        ks,
        alpha: alpha.value,
        kt,
        kt_length: 1.0,
        ior,
        distribution: builder.distribution,
        fresnel: builder.fresnel,
    };
    builder.set_material(command.line, MaterialKind::Brdf(brdf));
}

/// An error was already logged.
struct Wrong;

/// Kt and ior, if they follow the seven numbers of an opaque material and Kt is not 0.
fn transmission(arguments: &mut Arguments, log: &mut Log) -> Result<Option<[Number; 4]>, Wrong> {
    let rest = arguments.rest();
    let is_number = |text| prefix_length(text) > 0;
    let given = rest
        .iter()
        .take_while(|token| is_number(token.text))
        .count();
    if given == 0 {
        return Ok(None);
    }
    // With four arguments left the count is right, so one of them is not a number.
    if rest.len() < 4 {
        let place = rest[0].place.to(rest[given - 1].place);
        let message = format!("`brdf` takes 7 numbers or 11, not {}", 7 + given);
        log.error(place, message, "expected Kt(3) ior here, or nothing")
            .help(format!("usage: {}", arguments.usage));
        return Err(Wrong);
    }
    let kt = arguments.numbers(log, share(["Kt.r", "Kt.g", "Kt.b"], "Kt"));
    let is_opaque = kt.is_some_and(|kt| vector(&kt) == DVec3::ZERO);
    let ior = match is_opaque {
        // Files of the course have 0 where nothing is refracted.
        true => any("ior"),
        false => positive("ior", "the index of refraction"),
    };
    let ior = arguments.numbers(log, [ior]);
    match (kt, ior) {
        (Some(_), Some(_)) if is_opaque => Ok(None),
        (Some([r, g, b]), Some([ior])) => Ok(Some([r, g, b, ior])),
        _ => Err(Wrong),
    }
}

/// `light r g b`
pub(super) fn light(builder: &mut Builder, arguments: &mut Arguments) {
    if let Some(radiance) = arguments.numbers(&mut builder.log, RADIANCE) {
        let line = arguments.command().place.line;
        builder.set_material(line, MaterialKind::Light(vector(&radiance)));
    }
}

/// `distribution auto|phong|beckmann|ggx`
pub(super) fn distribution(builder: &mut Builder, arguments: &mut Arguments) {
    let choices = [
        ("auto", None),
        ("phong", Some(Distribution::Phong)),
        ("beckmann", Some(Distribution::Beckmann)),
        ("ggx", Some(Distribution::Ggx)),
    ];
    if let Some(chosen) = choice(arguments, &mut builder.log, &choices) {
        builder.distribution = chosen;
        builder.words.distribution = match chosen {
            Some(_) => arguments.command().place.line,
            None => 0,
        };
    }
}

/// `fresnel schlick|exact`
pub(super) fn fresnel(builder: &mut Builder, arguments: &mut Arguments) {
    let choices = [("schlick", Fresnel::Schlick), ("exact", Fresnel::Exact)];
    if let Some(chosen) = choice(arguments, &mut builder.log, &choices) {
        builder.fresnel = Some(chosen);
        builder.words.fresnel = arguments.command().place.line;
    }
}

/// The meaning of the next argument; an error if it is none of `choices`.
fn choice<T: Copy>(arguments: &mut Arguments, log: &mut Log, choices: &[(&str, T)]) -> Option<T> {
    let words: Vec<_> = choices.iter().map(|(word, _)| *word).collect();
    let token = arguments.word(log, &words.join(" or "))?;
    let chosen = choices.iter().find(|(word, _)| *word == token.text);
    if chosen.is_none() {
        let command = arguments.command().text;
        let message = format!("`{command}` cannot be `{}`", shorten(token.text));
        let help = match closest(token.text, &words) {
            Some(word) => format!("did you mean `{word}`?"),
            None => format!("usage: {}", arguments.usage),
        };
        log.error(token.place, message, "").help(help);
    }
    chosen.map(|(_, value)| *value)
}
