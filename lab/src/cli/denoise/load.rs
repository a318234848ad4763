//! Finding the denoiser.

use std::path::{Path, PathBuf};

use super::arguments::By;
use crate::cli::exit::warn;
use vkpt::denoise::{Denoiser, Oidn, usual_places};

/// Names the library, as `--oidn` does.
const VARIABLE: &str = "VKPT_OIDN";

/// What denoises, as `by` says; `oidn` is the library or its folder, where one is named.
///
/// # Errors
/// A library that is asked for and not to be had, as a sentence.
pub fn load(oidn: Option<&Path>, by: By) -> Result<Denoiser, String> {
    if by == By::Nlm {
        return Ok(Denoiser::Nlm);
    }
    if let Some((path, named)) = named(oidn) {
        let oidn = Oidn::at(&path);
        let oidn = oidn.map_err(|error| format!("{named} {}: {error}", path.display()))?;
        return Ok(Denoiser::Oidn(oidn));
    }
    let folders = usual_places(|name| std::env::var_os(name));
    match (Oidn::found(&folders), by) {
        (Ok(Some(oidn)), _) => Ok(Denoiser::Oidn(oidn)),
        (Ok(None), By::Oidn) => Err(
            "Open Image Denoise is not here: pip install pyoidn brings it, and --oidn PATH names its library"
                .to_owned(),
        ),
        (Err(error), By::Oidn) => Err(format!("Open Image Denoise: {error}")),
        (Err(error), _) => {
            warn(&format!(
                "Open Image Denoise: {error}; vkpt's own non-local means denoise"
            ));
            Ok(Denoiser::Nlm)
        }
        (Ok(None), _) => Ok(Denoiser::Nlm),
    }
}

/// The library that is asked for, and by what.
fn named(oidn: Option<&Path>) -> Option<(PathBuf, &'static str)> {
    let flag = oidn.map(|path| (path.to_owned(), "--oidn"));
    let variable = || std::env::var_os(VARIABLE).filter(|value| !value.is_empty());
    flag.or_else(|| variable().map(|path| (path.into(), VARIABLE)))
}
