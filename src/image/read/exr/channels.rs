//! Which of an EXR's channels are the picture.

use ::exr::meta::header::Header;

use crate::image::DecodeError;

/// Three channels of one part of the file.
#[derive(Debug)]
pub struct Rgb {
    /// Index of the part's header.
    pub part: usize,
    /// Places of R, G and B in that header's list.
    pub channels: [usize; 3],
}

/// Those of the first part with R, G and B; where there is none, those of the only layer that has them.
pub fn choose(headers: &[Header]) -> Result<Rgb, DecodeError> {
    if let Some(plain) = (0..headers.len()).find_map(|part| rgb(headers, part, "")) {
        return Ok(plain);
    }
    let mut layers: Vec<(String, Rgb)> = Vec::new();
    for (part, header) in headers.iter().enumerate() {
        for name in names(header) {
            let Some(layer) = name.strip_suffix('R').filter(|l| l.ends_with('.')) else {
                continue;
            };
            let found = rgb(headers, part, layer);
            layers.extend(found.map(|rgb| (layer.trim_end_matches('.').to_owned(), rgb)));
        }
    }
    match layers.len() {
        0 => Err(DecodeError::Missing {
            channels: headers.iter().flat_map(names).collect(),
        }),
        1 => Ok(layers.remove(0).1),
        _ => Err(DecodeError::Ambiguous {
            layers: layers.into_iter().map(|(layer, _)| layer).collect(),
        }),
    }
}

/// The three channels of a part that have this prefix, if all are there.
fn rgb(headers: &[Header], part: usize, prefix: &str) -> Option<Rgb> {
    let place = |letter| {
        let name = format!("{prefix}{letter}");
        names(&headers[part]).position(|channel| channel == name)
    };
    Some(Rgb {
        part,
        channels: [place('R')?, place('G')?, place('B')?],
    })
}

fn names(header: &Header) -> impl Iterator<Item = String> {
    header.channels.list.iter().map(|c| c.name.to_string())
}
