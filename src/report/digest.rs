//! A digest that identifies a picture's values.

use crate::film::Film;

/// A digest of all values, bit by bit, in hexadecimal.
pub fn digest(film: &Film) -> String {
    let mut hasher = blake3::Hasher::new();
    for side in [film.width, film.height] {
        hasher.update(&side.to_le_bytes());
    }
    for value in film.rgb.as_flattened() {
        hasher.update(&value.to_le_bytes());
    }
    hasher.finalize().to_hex()[..32].to_owned()
}
