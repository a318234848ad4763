//! `vkpt compare A B`: the distance of pictures, and whether it is chance.

use super::arguments::PictureArguments;
use super::known::Known;
use crate::cli::console::Console;
use crate::cli::destination::{Destination, Written, all_written};
use crate::cli::exit::{Ending, Failure};
use crate::cli::inputs::spare;
use crate::cli::writable;
use crate::compare::report::{self, Comparison, Tested};
use vkpt::film::Film;
use vkpt::image::{Format, Frame, Labels, encode};
use vkpt::metrics::blocks::{ALPHA, BlockTest, z_test};
use vkpt::metrics::flip::{Viewing, flip};
use vkpt::metrics::{self, Errors, HEATMAP_RANGE, MetricsError, Pair, trimmed};

/// Compares A with B, or both with the reference. The flags decide which differences are failures.
pub fn pictures(arguments: &PictureArguments) -> Result<Ending, Failure> {
    let _claims = writable::check(&arguments.heatmap)?;
    let known = Known::read_all(arguments)?;
    let inputs: Vec<_> = known.iter().flat_map(Known::inputs).collect();
    spare(&inputs, &arguments.heatmap)?;
    let Some((reference, tested)) = known.split_last() else {
        return Err(Failure::Usage("two pictures are needed".to_owned()));
    };
    let comparison = compare(arguments.exposure, tested, reference).map_err(Failure::Pictures)?;
    let console = Console::beside(&arguments.heatmap);
    let printed = console.print(&report::comparison(&comparison));
    let written = match &arguments.heatmap {
        None => Ok(()),
        Some(to) => write_heatmap(&heatmap(tested, reference)?, to)
            .and_then(|()| console.print(&legend(to))),
    };
    all_written([printed, written])?;
    verdict(arguments, &comparison)
}

/// Compares each of `tested` with the reference.
pub fn compare(
    exposure: f64,
    tested: &[Known],
    reference: &Known,
) -> Result<Comparison, Vec<String>> {
    let viewing = Viewing {
        exposure,
        ..Viewing::default()
    };
    let film = &reference.picture.film;
    let mut comparison = Comparison {
        reference: reference.name(),
        size: [film.width, film.height],
        exposure,
        pixels_per_degree: viewing.pixels_per_degree,
        tested: Vec::new(),
    };
    for known in tested {
        let failure = |error: MetricsError| {
            vec![format!(
                "{} and {}: {error}",
                known.name(),
                reference.name()
            )]
        };
        known.same_place(reference)?;
        let pair = Pair::new(&known.picture.film, film).map_err(failure)?;
        comparison.tested.push(Tested {
            name: known.name(),
            errors: Errors::of(&pair),
            flip: trimmed(&flip(&pair, &viewing).map_err(failure)?.errors),
            z_test: block_test(known, reference).map_err(failure)?,
        });
    }
    Ok(comparison)
}

/// The z-test if both pictures have standard errors, otherwise why it was skipped.
fn block_test(a: &Known, b: &Known) -> Result<Result<BlockTest, String>, MetricsError> {
    Ok(match (a.estimate(), b.estimate()) {
        (Ok(a), Ok(b)) => Ok(z_test(&a, &b, ALPHA)?),
        (Err(why), _) | (_, Err(why)) => Err(why),
    })
}

/// The heat maps of all `tested`, side by side.
fn heatmap(tested: &[Known], reference: &Known) -> Result<Film, Failure> {
    let failure = |error: MetricsError| Failure::Pictures(vec![error.to_string()]);
    let mut maps = Vec::new();
    for known in tested {
        let pair = Pair::new(&known.picture.film, &reference.picture.film).map_err(failure)?;
        maps.push(metrics::heatmap(&pair));
    }
    Ok(side_by_side(&maps))
}

fn write_heatmap(film: &Film, to: &Destination) -> Written {
    let labels = Labels {
        exposure: 0.0,
        software: vkpt::report::SOFTWARE,
        notes: &[],
    };
    to.write(|mut out| encode(&Frame::whole(film), Format::Png, &labels, &mut out))
}

/// The meaning of a heat map's colours.
fn legend(written: &Destination) -> String {
    let [low, high] = HEATMAP_RANGE;
    format!(
        "\nwrote {written}: relMSE of each pixel, from black ({low:e} or less) through violet and orange to pale yellow ({high} or more)\n"
    )
}

/// Pictures of one size as one, from left to right.
fn side_by_side(films: &[Film]) -> Film {
    let (width, height) = films.first().map_or((0, 0), |f| (f.width, f.height));
    let row = |y: u32| {
        let span = (y * width) as usize..((y + 1) * width) as usize;
        films.iter().flat_map(move |f| f.rgb[span.clone()].to_vec())
    };
    Film {
        width: width * films.len() as u32,
        height,
        rgb: (0..height).flat_map(row).collect(),
    }
}

/// Whether the pictures are as close as the flags demand.
fn verdict(arguments: &PictureArguments, comparison: &Comparison) -> Result<Ending, Failure> {
    let mut broken = Vec::new();
    for Tested {
        name,
        errors,
        z_test,
        ..
    } in &comparison.tested
    {
        if let Some(most) = arguments
            .max_relmse
            .filter(|&most| errors.rel_mse.all > most)
        {
            let found = errors.rel_mse.all;
            broken.push(format!(
                "{name}: relMSE {found:.4e} is above --max-relmse {most:e}"
            ));
        }
        match z_test {
            _ if !arguments.z_test => {}
            Ok(test) if test.passes() => {}
            Ok(test) => broken.push(format!(
                "{name}: {} block means differ by more than their standard errors explain (--z-test)",
                test.rejected()
            )),
            Err(why) => return Err(Failure::Usage(format!("--z-test: {why}"))),
        }
    }
    if broken.is_empty() {
        Ok(Ending::Complete)
    } else {
        Err(Failure::Comparison(broken))
    }
}
