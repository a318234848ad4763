//! Files that can't be read give an error with the file's name, in words that help.

use std::fs;
use std::path::Path;

use vkpt::image::{Format, decode, read};

use super::films::{data, encoded, film};

fn error(path: &Path) -> String {
    read(path).expect_err("must be refused").to_string()
}

/// The error of a file of data/, less the name that it begins with.
#[track_caller]
fn refusal(name: &str) -> String {
    let path = data(name);
    let text = error(&path);
    let printed = text.strip_prefix(&format!("{}: ", path.display()));
    printed.unwrap_or_else(|| panic!("{text}")).to_owned()
}

fn of_bytes(bytes: &[u8]) -> String {
    decode(bytes).expect_err("must be refused").to_string()
}

/// A message's quotation from a file is escaped before it reaches a terminal.
#[test]
fn a_message_has_no_control_characters() {
    let hdr = b"#?RADIANCE\nFORMAT=32-bit_\x1b[2J\n\n-Y 1 +X 1\n";
    let printed = of_bytes(hdr);
    assert!(printed.contains("32-bit_\u{fffd}[2J"), "{printed:?}");
}

#[test]
fn files_that_are_no_pictures() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name| folder.path().join(name);
    fs::write(path("empty.exr"), "").expect("written");
    fs::write(path("scene.exr"), "# a scene\n").expect("written");
    let printed = |path: &Path| {
        let text = error(path);
        let printed = text.strip_prefix(&format!("{}: ", path.display()));
        printed.expect("the file's name first").to_owned()
    };
    assert_eq!(printed(&path("empty.exr")), "is empty");
    let no_picture = "is not a picture in a supported format: EXR, HDR or PNG";
    assert_eq!(printed(&path("scene.exr")), no_picture);
    assert_eq!(printed(folder.path()), "is a folder");
    let missing = std::io::Error::from_raw_os_error(2).to_string();
    assert_eq!(printed(&path("none.exr")), missing);
    #[cfg(unix)]
    assert_eq!(
        printed(Path::new("/dev/zero")),
        "is neither a file nor a folder"
    );
}

#[test]
fn exr_without_a_picture_to_compare() {
    let expected = [
        (
            "only-y",
            "has no channels R, G and B; its channels are A, Y",
        ),
        (
            "layers-two",
            "has R, G and B in several layers, which is ambiguous: diffuse, specular",
        ),
        (
            "uint",
            "has integers (UINT) in channel R, but radiance needs floats",
        ),
        (
            "deep",
            "not supported: deep data, which has several values per pixel",
        ),
        (
            "smooth-htj2k32",
            "not supported: yet unimplemented compression method: ht j2k 32 compression",
        ),
        (
            "aces",
            "its colours are not sRGB: its `chromaticities` differ; convert them first",
        ),
        // Rows and columns of the full picture: the data window begins at 2,−1 of it.
        (
            "not-finite",
            "3 of its values are NaN or infinite; the first is NaN in pixel 6,0 from the top left, channel B",
        ),
    ];
    for (name, text) in expected {
        assert_eq!(refusal(&format!("{name}.exr")), text);
    }
}

#[test]
fn png_that_is_not_srgb() {
    let expected = [
        (
            "gamma-linear",
            "its gAMA chunk names another transfer function",
        ),
        ("primaries-p3", "its cHRM chunk names other primaries"),
        ("cicp-pq", "its cICP chunk names other colours"),
        ("profile", "it has a colour profile (iCCP chunk)"),
    ];
    for (name, why) in expected {
        assert_eq!(
            refusal(&format!("{name}.png")),
            format!("its colours are not sRGB: {why}; convert them first")
        );
    }
}

#[test]
fn hdr_of_other_colours_sizes_and_orders() {
    let header = |lines: &str, size: &str| format!("#?RADIANCE\n{lines}\n\n{size}\n....");
    let expected = [
        (
            header("COLORCORR=1 2 1", "-Y 1 +X 1"),
            "its colours are not sRGB: its COLORCORR changes them; convert them first",
        ),
        (
            header("PRIMARIES=.7 .3 .2 .7 .1 .1 .33 .33", "-Y 1 +X 1"),
            "its colours are not sRGB: its PRIMARIES differ; convert them first",
        ),
        (
            header("PRIMARIES=1 2", "-Y 1 +X 1"),
            "is damaged: primaries of 1 2",
        ),
        (
            header("EXPOSURE=0", "-Y 1 +X 1"),
            "is damaged: an exposure of 0",
        ),
        (header("EXPOSURE=1", "-Y 0 +X 5"), "has no pixels"),
        (
            header("EXPOSURE=1", "-Y 16385 +X 16384"),
            "16384×16385 pixels are too many: the limit is 2²⁸",
        ),
        (
            header("EXPOSURE=1", "-Y 16384 +X 16384"),
            "is damaged: 45 bytes cannot contain 16384×16384 pixels",
        ),
        (
            header("EXPOSURE=1", "-Y 2 +X 1"),
            "is damaged: it is truncated",
        ),
    ];
    for (file, text) in expected {
        assert_eq!(of_bytes(file.as_bytes()), text, "{file}");
    }
    for unsupported in [
        header("FORMAT=32-bit_rle_xyze", "-Y 1 +X 1"),
        header("EXPOSURE=1", "+Y 1 +X 1"),
    ] {
        let text = of_bytes(unsupported.as_bytes());
        assert!(text.starts_with("not supported: "), "{text}");
    }
}

#[test]
fn an_exr_or_png_cut_short() {
    for format in [Format::Exr, Format::Png] {
        let bytes = encoded(&film(), format, 0.0);
        for length in [bytes.len() / 4, bytes.len() / 2, bytes.len() - 1] {
            let text = of_bytes(&bytes[..length]);
            assert!(text.starts_with("is damaged: "), "{text}");
        }
    }
}

/// Where the table of an EXR's `chunks` is: the first of its u64 is where the table ends.
fn table(file: &[u8], chunks: usize) -> usize {
    let points_behind = |&at: &usize| {
        let first = u64::from_le_bytes(file[at..at + 8].try_into().expect("8 bytes"));
        first == (at + 8 * chunks) as u64
    };
    let at = (0..file.len() - 8).find(points_behind);
    at.expect("a table of chunks")
}

#[test]
fn an_exr_with_a_block_twice() {
    let mut file = fs::read(data("half-rgba-no.exr")).expect("a file");
    let table = table(&file, 5);
    file.copy_within(table + 8..table + 16, table + 16);
    assert_eq!(
        of_bytes(&file),
        "is damaged: its blocks do not match its header"
    );
}

#[test]
fn an_exr_whose_block_claims_too_much() {
    let mut file = fs::read(data("smooth-dwaa.exr")).expect("a file");
    // Row and length, then DWA's counters, of which the last but one is that of the means.
    let counter = table(&file, 1) + 8 + 8 + 9 * 8;
    file[counter + 5] = 1;
    assert_eq!(
        of_bytes(&file),
        "is damaged: a chunk declares more than its block contains"
    );
}

#[test]
fn one_value_that_is_no_number() {
    let mut film = film();
    film.rgb[8][1] = f32::NEG_INFINITY;
    // Pixel 8 of 7 columns, in a frame that begins at 3,2.
    assert_eq!(
        of_bytes(&encoded(&film, Format::Exr, 0.0)),
        "1 of its values is NaN or infinite; the first is -inf in pixel 4,3 from the top left, channel G"
    );
}
