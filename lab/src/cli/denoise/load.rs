//! Finding the denoiser.

use std::path::{Path, PathBuf};

use super::arguments::By;
use crate::cli::exit::warn;
use vkpt::denoise::{Denoiser, Oidn, usual_places};

/// Names the library, as `--oidn` does.
const VARIABLE: &str = "VKPT_OIDN";

/// Loads the denoiser `by`; `oidn` is the library or its folder, if named.
///
/// # Errors
/// A requested library that is not available, as a sentence.
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
            "Open Image Denoise was not found: install it (pip install pyoidn), or name its library with --oidn PATH"
                .to_owned(),
        ),
        (Err(error), By::Oidn) => Err(format!("Open Image Denoise: {error}")),
        (Err(error), _) => {
            warn(&format!(
                "Open Image Denoise: {error}; denoising with vkpt's own non-local means instead"
            ));
            Ok(Denoiser::Nlm)
        }
        (Ok(None), _) => Ok(Denoiser::Nlm),
    }
}

/// The requested library, and the flag or variable that names it.
fn named(oidn: Option<&Path>) -> Option<(PathBuf, &'static str)> {
    let flag = oidn.map(|path| (path.to_owned(), "--oidn"));
    let variable = || std::env::var_os(VARIABLE).filter(|value| !value.is_empty());
    flag.or_else(|| variable().map(|path| (path.into(), VARIABLE)))
}
