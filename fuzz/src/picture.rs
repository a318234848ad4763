//! Pictures for comparison.

use vkpt::image::decode;

/// A picture of any format has a finite value for each pixel, or is refused.
pub fn picture(bytes: &[u8]) {
    match decode(bytes) {
        Ok(picture) => {
            let film = &picture.film;
            let [width, height] = [film.width, film.height].map(|n| n as usize);
            assert!(width > 0 && height > 0);
            assert_eq!(film.rgb.len(), width * height);
            let values = film.rgb.as_flattened();
            assert!(values.iter().all(|v| v.is_finite()));
        }
        Err(error) => super::has_message(&error),
    }
}
