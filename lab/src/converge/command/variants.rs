//! The scene, prepared for every model.

use super::arguments::ConvergeArguments;
use super::vary::{Combination, combinations};
use crate::cli::exit::Failure;
use crate::cli::inputs::Input;
use crate::cli::integrator::settled;
use crate::cli::job::{Loaded, Request};
use vkpt::prepared::Prepared;
use vkpt::render::{Job, KernelChoice, Until};
use vkpt::settings::{Integrator, Model};

/// The renderings, with every setting.
pub struct Variants {
    pub combinations: Vec<Combination>,
    /// The scene for each model that occurs: a picture to converge to.
    pub models: Vec<(Model, Prepared)>,
    /// The text of the scene file.
    pub text: String,
    /// The files that were read.
    pub inputs: Vec<Input>,
}

/// Lets the scene choose the integrator of the combinations that leave it open: the same for all of them, so that they
/// differ only in the settings that vary. Paths from the eye suit every scene.
fn settle(combinations: &mut [Combination], models: &[(Model, Prepared)]) {
    let chosen = |c: &Combination| {
        let (_, prepared) = models
            .iter()
            .find(|(model, _)| *model == c.settings.model)?;
        Some(settled(prepared, c.settings).settings.estimator.integrator)
    };
    let auto = || combinations.iter().filter(|c| c.auto);
    let first = auto().next().and_then(chosen);
    let one = first.filter(|_| auto().all(|c| chosen(c) == first));
    for combination in combinations.iter_mut().filter(|c| c.auto) {
        combination.settings.estimator.integrator = one.unwrap_or(Integrator::Path);
    }
}

impl Variants {
    /// Reads and prepares the scene; prints its warnings once.
    pub fn new(arguments: &ConvergeArguments) -> Result<Self, Failure> {
        let mut combinations = combinations(&arguments.settings, &arguments.vary)?;
        let loaded = Loaded::new(&arguments.request())?;
        let mut models: Vec<(Model, Prepared)> = Vec::new();
        for Combination { settings, .. } in &combinations {
            if models.iter().any(|(model, _)| *model == settings.model) {
                continue;
            }
            let request = Request {
                settings: *settings,
                ..arguments.request()
            };
            let prepared = match models.is_empty() {
                true => {
                    let ready = loaded.prepare(&request)?;
                    ready.job(&request)?;
                    ready.prepared
                }
                // Its warnings have been printed.
                false => loaded.prepare_in_silence(&request)?,
            };
            models.push((settings.model, prepared));
        }
        settle(&mut combinations, &models);
        Ok(Self {
            combinations,
            models,
            inputs: Input::of_scene(&arguments.scene, &loaded.scene),
            text: loaded.text,
        })
    }

    /// Width and height of the full picture.
    pub fn full_size(&self) -> [u32; 2] {
        let first = self.models.first();
        first.map_or([0, 0], |(_, prepared)| {
            [prepared.camera.width, prepared.camera.height]
        })
    }

    /// Width and height of the part that is rendered.
    pub fn size(&self, arguments: &ConvergeArguments) -> [u32; 2] {
        let crop = arguments
            .view
            .crop
            .map(|[x0, y0, x1, y1]| [x1 - x0, y1 - y0]);
        crop.unwrap_or(self.full_size())
    }

    /// The jobs of all variants.
    pub fn jobs<'a>(&'a self, arguments: &'a ConvergeArguments) -> Vec<Job<'a>> {
        let prepared = |model: Model| {
            let mut all = self.models.iter();
            all.find(|(other, _)| *other == model).map(|(_, p)| p)
        };
        let job = |Combination { settings, .. }: &Combination| {
            Some(Job {
                prepared: prepared(settings.model)?,
                settings: *settings,
                spp: arguments.spp,
                until: Until::default(),
                seed: arguments.seed,
                crop: arguments.view.crop,
                aovs: &[],
                classes: &[],
                kernel: KernelChoice::Composed,
            })
        };
        // Each has a model: `new` made one for it.
        self.combinations.iter().filter_map(job).collect()
    }
}
