//! One variant: its curve, and figures derived from it.

use serde::Serialize;

use super::ReferenceRecord;
use vkpt::metrics::convergence::{
    Curve, Figures, Floor, Interval, Metric, Reach, Reference, Step, Summary, efficiency, floor,
    ratio_of_efficiencies, reach, slope,
};
use vkpt::report::SettingsRecord;
use vkpt::settings::Settings;

/// The relMSE targets whose times are reported.
const TARGETS: [f64; 2] = [1e-2, 1e-3];

/// The data of a variant in addition to its curve.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// `connect=light normals=visible`; empty if nothing varies.
    pub name: &'a str,
    pub settings: &'a Settings,
    pub reference: &'a Reference,
    /// The name of the reference.
    pub reference_name: &'a str,
}

/// The convergence of a rendering.
#[derive(Clone, Debug, Serialize)]
pub struct VariantRecord {
    pub name: String,
    pub settings: SettingsRecord,
    pub reference: ReferenceRecord,
    /// Seconds from the prepared scene to the first sample, including compiling; not included in any step's seconds.
    pub set_up_s: f64,
    pub steps: Vec<StepRecord>,
    /// Seconds on the wall clock until the mean relMSE is down to each target.
    pub reach: Vec<ReachRecord>,
    /// The relMSE that no samples remove; `None` for fewer than three replicates.
    pub floor: Option<Floor>,
    /// False if the pictures do not converge to the reference; `None` for fewer than three replicates.
    pub converges: Option<bool>,
    /// Its efficiency relative to the first variant, at the last step; `None` for the first itself.
    pub against_first: Option<Interval>,
}

/// All replicates with the same number of samples.
#[derive(Clone, Debug, Serialize)]
pub struct StepRecord {
    pub spp: u32,
    /// Seconds of sampling of one replicate on the wall clock.
    pub wall_s: Interval,
    /// The same including set-up.
    pub wall_with_set_up_s: f64,
    /// By the device's timestamps.
    pub gpu_s: Option<Interval>,
    pub errors: Figures<ErrorRecord>,
    /// Local slope of relMSE over samples on log–log axes, from the step before.
    pub slope: Option<Interval>,
    /// 1/(relMSE · seconds on the wall clock).
    pub efficiency: Option<Interval>,
}

/// The errors of all replicates in one metric.
#[derive(Clone, Debug, Serialize)]
pub struct ErrorRecord {
    #[serde(flatten)]
    pub summary: Summary,
    /// The mean is not above the reference's own error: inconclusive.
    pub below_reference: bool,
    /// One for each replicate.
    pub replicates: Vec<f64>,
}

/// When a target is reached.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct ReachRecord {
    pub rel_mse: f64,
    #[serde(flatten)]
    pub reach: Reach,
}

impl VariantRecord {
    /// The figures of a curve; `first` is that of the variant to compare with.
    pub fn new(subject: &Subject, curve: &Curve, first: Option<&Curve>) -> Self {
        let floor = floor(&curve.pictures, subject.reference);
        let own = own(subject.reference, floor);
        let before = std::iter::once(None).chain(curve.steps.iter().map(Some));
        let steps: Vec<StepRecord> = curve
            .steps
            .iter()
            .zip(before)
            .filter_map(|(step, before)| StepRecord::new(step, before, curve.set_up_s, &own))
            .collect();
        Self {
            name: subject.name.to_owned(),
            settings: subject.settings.into(),
            reference: ReferenceRecord {
                name: subject.reference_name.to_owned(),
                own,
            },
            set_up_s: curve.set_up_s,
            reach: TARGETS.map(|target| reached(&steps, target)).to_vec(),
            steps,
            floor,
            converges: floor.map(|f| !f.is_there()),
            against_first: first.and_then(|first| against(first, curve)),
        }
    }

    /// Whether the pictures converge to something other than the reference.
    pub fn is_off(&self) -> bool {
        self.converges == Some(false)
    }
}

impl StepRecord {
    /// `None` for fewer than two replicates.
    fn new(
        step: &Step,
        before: Option<&Step>,
        set_up_s: f64,
        own: &Figures<Option<f64>>,
    ) -> Option<Self> {
        let rel_mse = step.means(Metric::RelMse);
        let wall_s = Interval::of_mean(&step.wall_s)?;
        let gpu_s = step.gpu_s.as_ref();
        Some(Self {
            spp: step.spp,
            wall_s,
            wall_with_set_up_s: wall_s.value + set_up_s,
            gpu_s: gpu_s.and_then(|seconds| Interval::of_mean(seconds)),
            errors: Figures::try_from_fn(|m| ErrorRecord::new(step, m, *own.of(m)))?,
            slope: before
                .and_then(|b| slope((b.spp, &b.means(Metric::RelMse)), (step.spp, &rel_mse))),
            efficiency: efficiency(&rel_mse, &step.wall_s),
        })
    }
}

impl ErrorRecord {
    fn new(step: &Step, metric: Metric, own: Option<f64>) -> Option<Self> {
        let summary = Summary::of(&step.errors(metric))?;
        Some(Self {
            below_reference: own.is_some_and(|own| summary.mean.value <= own),
            replicates: step.means(metric),
            summary,
        })
    }
}

/// The reference's own error, if known. Otherwise the floor is its only estimate: errors below it cannot be distinguished
/// from the reference's.
fn own(reference: &Reference, floor: Option<Floor>) -> Figures<Option<f64>> {
    let mut own = *reference.own();
    let there = floor.filter(Floor::is_there).map(|f| f.rel_mse);
    own.rel_mse = own.rel_mse.or(there);
    own
}

fn reached(steps: &[StepRecord], rel_mse: f64) -> ReachRecord {
    let point = |s: &StepRecord| (s.wall_s.value, s.errors.rel_mse.summary.mean.value);
    let curve: Vec<(f64, f64)> = steps.iter().map(point).collect();
    let reach = reach(&curve, rel_mse);
    ReachRecord { rel_mse, reach }
}

/// The efficiency of `curve` relative to `first`, at the last step that both have.
fn against(first: &Curve, curve: &Curve) -> Option<Interval> {
    let (a, b) = first.steps.iter().zip(&curve.steps).next_back()?;
    let of = |step: &Step| step.means(Metric::RelMse);
    ratio_of_efficiencies([&of(a), &a.wall_s], [&of(b), &b.wall_s])
}
