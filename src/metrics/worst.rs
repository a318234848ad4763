//! The pixels with the largest share of a picture's error.

use super::{Pair, relative_squared_errors};

/// A pixel and its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstPixel {
    /// Column and row from the top left.
    pub at: [u32; 2],
    pub test: [f32; 3],
    pub reference: [f32; 3],
    /// Its relative squared error, mean over its channels.
    pub error: f64,
    /// Its share of the sum over all pixels; 0 if there is no error at all.
    pub share: f64,
}

/// The `count` pixels with the largest relative squared errors, the worst first; among equals, the first in the
/// picture.
pub fn worst_pixels(pair: &Pair, count: usize) -> Vec<WorstPixel> {
    let errors = relative_squared_errors(pair);
    let sum: f64 = errors.iter().sum();
    let mut order: Vec<usize> = (0..errors.len()).collect();
    order.sort_by(|&i, &j| errors[j].total_cmp(&errors[i]));
    let width = pair.test().width as usize;
    let pixel = |i: usize| WorstPixel {
        // The film's size fits u32, so these do too.
        at: [i % width, i / width].map(|side| side as u32),
        test: pair.test().rgb[i],
        reference: pair.reference().rgb[i],
        error: errors[i],
        share: if sum > 0.0 { errors[i] / sum } else { 0.0 },
    };
    order.into_iter().take(count).map(pixel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Film;

    #[test]
    fn the_worst_come_first_with_their_share() {
        let black = Film {
            width: 3,
            height: 2,
            rgb: vec![[0.0; 3]; 6],
        };
        let mut test = black.clone();
        // x²/0.01 in one channel of three: 1/3·100 x². Computed by hand: 12, 3 and 3.
        test.rgb[4] = [0.0, 0.6, 0.0];
        test.rgb[1] = [0.3, 0.0, 0.0];
        test.rgb[2] = [0.0, 0.0, 0.3];
        let worst = worst_pixels(&Pair::new(&test, &black).expect("two pictures"), 3);
        let at: Vec<_> = worst.iter().map(|w| w.at).collect();
        assert_eq!(at, [[1, 1], [1, 0], [2, 0]]);
        assert!((worst[0].error - 12.0).abs() < 1e-5);
        assert!((worst[0].share - 12.0 / 18.0).abs() < 1e-6);
        assert_eq!(worst[0].test, [0.0, 0.6, 0.0]);
        let none = worst_pixels(&Pair::new(&black, &black).expect("two pictures"), 9);
        assert_eq!((none.len(), none[0].share), (6, 0.0));
    }
}
