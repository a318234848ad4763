//! Selects the channels of an EXR that form the picture.

use ::exr::meta::header::Header;

use crate::image::DecodeError;

/// Three channels of one part of the file.
#[derive(Debug)]
pub struct Rgb {
    /// Index of the part's header.
    pub part: usize,
    /// Indices of R, G and B in that header's list.
    pub channels: [usize; 3],
}

/// The channels of the first part with R, G and B; otherwise those of the only layer that has them.
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

/// The channels of a layer: three that end in R, G and B or X, Y and Z, or a single one.
pub fn layer(headers: &[Header], layer: &str) -> Result<Rgb, DecodeError> {
    let of = |part: usize, channels: [String; 3]| {
        let place = |name: &String| names(&headers[part]).position(|channel| channel == *name);
        let [r, g, b] = channels.each_ref().map(place);
        Some(Rgb {
            part,
            channels: [r?, g?, b?],
        })
    };
    let spellings = [
        ["R", "G", "B"].map(|end| format!("{layer}.{end}")),
        ["X", "Y", "Z"].map(|end| format!("{layer}.{end}")),
        [(); 3].map(|()| layer.to_owned()),
    ];
    let mut all = (0..headers.len()).flat_map(|part| spellings.iter().map(move |s| (part, s)));
    all.find_map(|(part, spelling)| of(part, spelling.clone()))
        .ok_or_else(|| DecodeError::NoLayer {
            layer: layer.to_owned(),
            channels: headers.iter().flat_map(names).collect(),
        })
}

/// The three channels of a part with this prefix, if all are present.
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
