//! The pictures that a rendering writes, and the format of each.

use std::path::PathBuf;

use vkpt::image::Format;
use vkpt::image::file::{denoised_path, stderr_path};
use vkpt::report::names::Named;
use vkpt_lab::cli::destination::Destination;
use vkpt_lab::cli::exit::Failure;

/// A picture to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    pub to: Destination,
    pub format: Format,
}

/// The pictures of `-o`.
///
/// `--format` is the format of every picture whose name does not imply one. If all names do, it must agree with them.
pub fn pictures(outputs: &[Destination], format: Option<Format>) -> Result<Vec<Picture>, Failure> {
    let named = |to: &Destination| to.path().and_then(Format::of);
    if let Some(format) = format
        && outputs.iter().all(|to| named(to).is_some())
        && let Some(other) = outputs.iter().find(|to| named(to) != Some(format))
    {
        let name = format.name();
        return Err(Failure::Usage(format!(
            "--format {name} contradicts -o {other}: change the ending, or omit --format"
        )));
    }
    let picture = |to: &Destination| match named(to).or(format) {
        Some(format) => Ok(Picture {
            to: to.clone(),
            format,
        }),
        None => Err(Failure::Usage(formatless(to))),
    };
    outputs.iter().map(picture).collect()
}

fn formatless(to: &Destination) -> String {
    match to {
        Destination::Stdout => {
            "-o - needs --format png, hdr or exr: stdout has no file name".to_owned()
        }
        Destination::File(path) => format!(
            "-o {}: the ending must be .png, .hdr, .exr or .vkpt; for any other, give the picture's format with --format",
            path.display()
        ),
    }
}

/// `NAME-stderr.exr` next to each picture `NAME.png` or `NAME.exr`, one for all that differ only in their ending.
pub fn beside(pictures: &[Picture], spp: u32) -> Result<Vec<Picture>, Failure> {
    if spp < 2 {
        return Err(Failure::Usage(
            "--aov stderr needs --spp 2 or more: a single sample has no standard error".to_owned(),
        ));
    }
    let mut paths: Vec<PathBuf> = Vec::new();
    for picture in pictures.iter().filter_map(|picture| picture.to.neighbour()) {
        let path = stderr_path(picture);
        if pictures.iter().any(|other| other.to.path() == Some(&path)) {
            return Err(Failure::Usage(format!(
                "--aov stderr would overwrite the picture {}: give the picture another name",
                path.display()
            )));
        }
        if !paths.contains(&path) {
            paths.push(path);
        }
    }
    if paths.is_empty() {
        return Err(Failure::Usage(
            "--aov stderr is written next to a picture, which stdout, devices and pipes do not allow: add -o FILE"
                .to_owned(),
        ));
    }
    let picture = |path| Picture {
        to: Destination::File(path),
        format: Format::Exr,
    };
    Ok(paths.into_iter().map(picture).collect())
}

/// `NAME-denoised.EXT` next to each picture `NAME.EXT` that is a file.
pub fn denoised(pictures: &[Picture]) -> Result<Vec<Picture>, Failure> {
    let mut all = Vec::new();
    for Picture { to, format } in pictures {
        let Some(path) = to.neighbour() else { continue };
        let path = denoised_path(path);
        if pictures.iter().any(|other| other.to.path() == Some(&path)) {
            return Err(Failure::Usage(format!(
                "--denoise would overwrite the picture {}: give the picture another name",
                path.display()
            )));
        }
        all.push(Picture {
            to: Destination::File(path),
            format: *format,
        });
    }
    match all.is_empty() {
        true => Err(Failure::Usage(
            "--denoise writes next to a picture, which stdout, devices, pipes and .vkpt files do not allow: add -o FILE"
                .to_owned(),
        )),
        false => Ok(all),
    }
}

#[cfg(test)]
mod tests {
    use std::ffi::OsString;

    use super::*;

    /// `name:format` of each picture, or the message.
    fn chosen(outputs: &[&str], format: Option<Format>) -> Result<String, String> {
        let outputs: Vec<_> = outputs
            .iter()
            .map(|name| Destination::from(OsString::from(name)))
            .collect();
        match pictures(&outputs, format) {
            Ok(all) => {
                let named = |p: &Picture| format!("{}:{}", p.to, p.format.name());
                Ok(all.iter().map(named).collect::<Vec<_>>().join(" "))
            }
            Err(Failure::Usage(message)) => Err(message),
            Err(other) => panic!("{other:?}"),
        }
    }

    #[test]
    fn names_give_formats_and_the_flag_gives_the_others() {
        const PNG: Option<Format> = Some(Format::Png);
        let rows: [(&[&str], _, &str); 7] = [
            (&["b.EXR"], None, "b.EXR:exr"),
            (&["b.exr"], Some(Format::Exr), "b.exr:exr"),
            (&["-"], PNG, "stdout:png"),
            (&["b"], PNG, "b:png"),
            (&["b.0001"], PNG, "b.0001:png"),
            (&["-", "b.exr"], PNG, "stdout:png b.exr:exr"),
            (&["b.exr", "c.hdr"], None, "b.exr:exr c.hdr:hdr"),
        ];
        for (outputs, format, expected) in rows {
            assert_eq!(chosen(outputs, format).as_deref(), Ok(expected));
        }
        let refused: [(&[&str], _, &str); 5] = [
            (&["-"], None, "-o - needs --format"),
            (&["b.jpg"], None, "-o b.jpg: the ending"),
            (&["b.exr", "c"], None, "-o c: the ending"),
            (&["b.exr"], PNG, "--format png contradicts -o b.exr"),
            (&["a.png", "b.exr"], PNG, "contradicts -o b.exr"),
        ];
        for (outputs, format, words) in refused {
            let message = chosen(outputs, format).expect_err("refused");
            assert!(message.contains(words), "{message}");
        }
    }
}
