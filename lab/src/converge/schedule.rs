//! The schedule: variants are interleaved, so that drift of the machine affects all of them alike.

use std::sync::atomic::AtomicBool;

use super::{ConvergeError, Part, Progress};
use vkpt::film::Film;
use vkpt::metrics::convergence::{Curve, Reference, Step};
use vkpt::metrics::flip::Viewing;
use vkpt::render::{Engine, Job, Replicates, Took};

/// A rendering to measure, and its reference.
#[derive(Clone, Copy)]
pub struct Variant<'a> {
    pub job: &'a Job<'a>,
    pub reference: &'a Reference,
    /// Processing of each picture before it is judged.
    pub finish: Option<&'a Finish<'a>>,
}

/// Makes another picture from a picture and the two halves of its samples, and returns it with the seconds taken, or an error.
pub type Finish<'a> = dyn Fn(&Film, [&Film; 2]) -> Result<(Film, f64), String> + 'a;

/// The amount of rendering.
#[derive(Clone, Debug)]
pub struct Plan {
    /// One for each replicate; the same for all variants.
    pub seeds: Vec<u32>,
    /// The maximum seconds of sampling, of all replicates and variants together. A step that would not fit is not started:
    /// as each doubles the samples, up to half of the time may remain. The first is always rendered.
    pub seconds: f64,
    /// Maximum samples per pixel.
    pub spp: u32,
    /// FLIP's viewing conditions.
    pub viewing: Viewing,
}

/// A curve for each variant, all with the same steps.
#[derive(Clone, Debug)]
pub struct Measured {
    pub curves: Vec<Curve>,
    /// Seconds of sampling, of all replicates and variants together; including an unfinished step.
    pub spent_s: f64,
    /// Stopped before the plan's end. An unfinished step is not reported.
    pub interrupted: bool,
}

/// Renders and judges. Compiling, first dispatches and judging do not count as sampling time.
///
/// # Errors
/// Those of a rendering; a reference of another size.
pub fn measure(
    variants: &[Variant],
    engine: &Engine,
    plan: &Plan,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Measured, ConvergeError> {
    let mut bench = Bench::new(variants, engine, plan)?;
    let mut spp = 1;
    let interrupted = loop {
        if !bench.advance(spp, stop, progress)? {
            break true;
        }
        bench.judge(spp)?;
        // The next step adds as many samples as all steps so far.
        let next = spp.checked_mul(2).filter(|&next| next <= plan.spp);
        match next {
            Some(next) if 2.0 * bench.spent <= plan.seconds => spp = next,
            _ => break false,
        }
    };
    Ok(Measured {
        spent_s: bench.spent,
        curves: bench.curves(),
        interrupted,
    })
}

/// The running experiment.
struct Bench<'a> {
    variants: &'a [Variant<'a>],
    plan: &'a Plan,
    entrants: Vec<Entrant<'a>>,
    /// Seconds of sampling so far.
    spent: f64,
}

struct Entrant<'a> {
    replicates: Replicates<'a>,
    /// Of each replicate, so far.
    took: Vec<Took>,
    curve: Curve,
}

impl<'a> Bench<'a> {
    fn new(
        variants: &'a [Variant<'a>],
        engine: &'a Engine,
        plan: &'a Plan,
    ) -> Result<Self, ConvergeError> {
        let entrant = |variant: &'a Variant<'a>| -> Result<_, ConvergeError> {
            let replicates = Replicates::new(variant.job, engine, &plan.seeds)?;
            let curve = Curve {
                set_up_s: replicates.set_up_s(),
                ..Curve::default()
            };
            Ok(Entrant {
                replicates,
                took: vec![Took::default(); plan.seeds.len()],
                curve,
            })
        };
        Ok(Self {
            variants,
            plan,
            entrants: variants.iter().map(entrant).collect::<Result<_, _>>()?,
            spent: 0.0,
        })
    }

    /// Brings every replicate to `spp` samples; false if `stop` came first. Each replicate is rendered by all variants one
    /// after the other, in alternating order, so that a steady drift cancels.
    fn advance(
        &mut self,
        spp: u32,
        stop: &AtomicBool,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<bool, ConvergeError> {
        let (replicates, variants) = (self.plan.seeds.len(), self.variants.len());
        for i in 0..replicates {
            for turn in 0..variants {
                let v = if i % 2 == 0 {
                    turn
                } else {
                    variants - 1 - turn
                };
                let entrant = &mut self.entrants[v];
                let took = entrant.replicates.advance(i, spp, stop)?;
                self.spent += took.wall_s;
                if entrant.replicates.done(i) < spp {
                    return Ok(false);
                }
                entrant.took[i].add(took);
                progress(Progress {
                    part: Part::Step {
                        number: entrant.curve.steps.len() + 1,
                        replicate: [i + 1, replicates],
                        variant: [turn + 1, variants],
                    },
                    spp,
                    spent_s: self.spent,
                    seconds: self.plan.seconds,
                });
            }
        }
        Ok(true)
    }

    /// The pictures of all replicates, and the seconds of finishing each.
    fn pictures(
        entrant: &Entrant,
        variant: &Variant,
    ) -> Result<(Vec<Film>, Vec<f64>), ConvergeError> {
        let picture = |i| {
            let picture = entrant.replicates.picture(i);
            let Some(finish) = variant.finish else {
                return Ok((picture, 0.0));
            };
            let [a, b] = entrant.replicates.halves(i);
            finish(&picture, [&a, &b]).map_err(ConvergeError::Finish)
        };
        (0..entrant.took.len()).map(picture).collect()
    }

    /// Compares every replicate with its variant's reference.
    fn judge(&mut self, spp: u32) -> Result<(), ConvergeError> {
        for (entrant, variant) in self.entrants.iter_mut().zip(self.variants) {
            let (pictures, finishing) = Self::pictures(entrant, variant)?;
            let figures = |film| variant.reference.figures(film, &self.plan.viewing);
            entrant.curve.steps.push(Step {
                spp,
                wall_s: (entrant.took.iter().zip(finishing))
                    .map(|(took, finishing)| took.wall_s + finishing)
                    .collect(),
                gpu_s: entrant.took.iter().map(|t| t.gpu_s).collect(),
                figures: pictures.iter().map(figures).collect::<Result<_, _>>()?,
                picture: pictures[0].clone(),
            });
            entrant.curve.pictures = pictures;
        }
        Ok(())
    }

    fn curves(self) -> Vec<Curve> {
        self.entrants.into_iter().map(|e| e.curve).collect()
    }
}
