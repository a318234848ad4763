//! Tiles: a picture larger than one dispatch is rendered in pieces.

use crate::reference::integrator::light::splat::Window;

/// A rectangle of pixels, from the top left of the full picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    pub x: u32,
    pub y: u32,
    pub width: u32,
    pub height: u32,
}

impl Tile {
    pub fn pixels(&self) -> u32 {
        self.width * self.height
    }

    /// Its pixels as the window of light paths.
    pub fn window(&self) -> Window {
        let Self {
            x,
            y,
            width,
            height,
        } = *self;
        Window {
            x,
            y,
            width,
            height,
        }
    }

    /// Whether it has a pixel of the full picture.
    pub fn contains(&self, [column, row]: [u32; 2]) -> bool {
        column.wrapping_sub(self.x) < self.width && row.wrapping_sub(self.y) < self.height
    }

    /// Column and row of pixel `i`, row by row, in the full picture.
    pub fn pixel(&self, i: u32) -> [u32; 2] {
        [self.x + i % self.width, self.y + i / self.width]
    }

    /// Number of one of its pixels, row by row.
    pub fn index(&self, [column, row]: [u32; 2]) -> u32 {
        (row - self.y) * self.width + column - self.x
    }
}

/// Cuts `area` into tiles of at most `most` ≥ 1 pixels: whole rows if a row fits, else pieces of rows.
pub fn tiles(area: Tile, most: u32) -> Vec<Tile> {
    let width = area.width.min(most);
    let height = (most / width).clamp(1, area.height);
    let mut all = Vec::new();
    for y in (0..area.height).step_by(height as usize) {
        for x in (0..area.width).step_by(width as usize) {
            all.push(Tile {
                x: area.x + x,
                y: area.y + y,
                width: width.min(area.width - x),
                height: height.min(area.height - y),
            });
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_every_pixel_once_and_keep_to_their_size() {
        for (width, height, most) in [(1, 1, 1), (400, 300, 65536), (7, 5, 3), (8192, 3, 5000)] {
            let area = Tile {
                x: 2,
                y: 9,
                width,
                height,
            };
            let mut seen = vec![0; (width * height) as usize];
            for t in tiles(area, most) {
                assert!(t.pixels() <= most, "{t:?}");
                for y in t.y..t.y + t.height {
                    for x in t.x..t.x + t.width {
                        seen[((y - 9) * width + x - 2) as usize] += 1;
                    }
                }
            }
            assert!(seen.iter().all(|&n| n == 1), "{width}×{height} by {most}");
        }
    }
}
