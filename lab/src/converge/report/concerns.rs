//! Findings that must not be overlooked, printed as warnings.

use super::Convergence;

/// A sentence for each variant that does not converge to the reference.
pub fn concerns(experiment: &Convergence) -> Vec<String> {
    let off = experiment.variants.iter().filter(|v| v.is_off());
    let concerns = off.filter_map(|variant| {
        let name = match variant.name.as_str() {
            "" => String::new(),
            name => format!("{name}: "),
        };
        let floor = variant.floor?;
        Some(format!(
            "{name}the pictures do not converge to the reference ({}): relMSE {:.1e} ± {:.1e} remains",
            variant.reference.name, floor.rel_mse, floor.standard_error
        ))
    });
    concerns.collect()
}
