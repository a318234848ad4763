//! Checks the sizes that a DWA chunk declares, because the crate allocates memory for them unchecked.

use ::exr::block::chunk::{Chunk, CompressedBlock};
use ::exr::compression::Compression;
use ::exr::error::Error;
use ::exr::meta::header::Header;

/// Refuses a chunk whose parts are larger unpacked than its block of pixels can be.
///
/// A chunk begins with 11 u64 (OpenEXR, internal_dwa_compressor.h, `DataSizesSingle`). These are sizes after unpacking:
/// of channels stored unchanged (1), of runs packed (6) and unpacked (7), and the numbers of coefficients other than
/// the mean (8) and of means (9) of all 8×8 blocks.
pub fn check(chunk: &Chunk, header: &Header) -> Result<(), Error> {
    let bytes = match (&chunk.compressed_block, header.compression) {
        (CompressedBlock::ScanLine(b), Compression::DWAA(_) | Compression::DWAB(_)) => {
            &b.compressed_pixels_le
        }
        (CompressedBlock::Tile(b), Compression::DWAA(_) | Compression::DWAB(_)) => {
            &b.compressed_pixels_le
        }
        _ => return Ok(()),
    };
    let tile = header.get_block_data_indices(&chunk.compressed_block)?;
    let size = header.get_absolute_block_pixel_coordinates(tile)?.size;
    let bytes_per_pixel = header.channels.bytes_per_pixel;
    if bytes.len() == size.area() * bytes_per_pixel {
        // Stored uncompressed, because compression did not help.
        return Ok(());
    }
    let whole_blocks = size.width().next_multiple_of(8) * size.height().next_multiple_of(8);
    // The factor 2 is generous: bytes without runs grow by 1/128 when they are packed.
    let most = (whole_blocks * bytes_per_pixel * 2) as u64;
    let counter = |i: usize| bytes.as_chunks().0.get(i).copied().map(u64::from_le_bytes);
    if [1, 6, 7, 8, 9]
        .into_iter()
        .filter_map(counter)
        .any(|claim| claim > most)
    {
        return Err(Error::Invalid(
            "a chunk declares more than its block contains".into(),
        ));
    }
    Ok(())
}
