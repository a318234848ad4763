//! Parts of pictures.

use vkpt::state::{Kept, parse, write};

/// A part is whole, has a value for each pixel and is written as it was read; or it is refused. Because a checksum
/// refuses nearly everything, the same bytes are also tried with the correct one.
pub fn part(bytes: &[u8]) {
    tried(bytes);
    if let Some(content) = bytes.len().checked_sub(blake3::OUT_LEN) {
        let content = &bytes[..content];
        tried(&[content, blake3::hash(content).as_bytes()].concat());
    }
}

fn tried(bytes: &[u8]) {
    match parse(bytes) {
        Ok(kept) => promises_kept(&kept),
        Err(error) => super::has_message(&error),
    }
}

fn promises_kept(kept: &Kept) {
    let [width, height] = kept.part.size();
    let range = kept.part.range();
    assert!(range.start < range.end);
    assert_eq!(kept.part.samples(), range.end - range.start);
    let picture = kept.part.picture();
    assert_eq!(picture.rgb.len(), width as usize * height as usize);
    let again = written(kept);
    let kept = parse(&again).expect("what was written");
    assert!(written(&kept) == again, "read and written again");
}

fn written(kept: &Kept) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&mut bytes, &kept.header, &kept.part).expect("a vector takes anything");
    bytes
}
