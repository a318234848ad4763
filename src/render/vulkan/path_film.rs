//! A path tracer's film on the host: the samples before the current block, and the film of that block, tile by tile.

use crate::film::Keeps;
use crate::part::{Part, PixelSums, Sums, Tally};
use crate::render::HostFilm;
use crate::render::tiles::Tile;

/// A tile between two of its slices.
pub struct TileFilm {
    pub tile: Tile,
    /// Of the current block, row by row.
    pub sums: Sums<f32>,
    /// The counters of that block.
    pub tally: Tally,
}

/// The film of a path tracer, with all its tiles.
pub struct PathFilm {
    area: Tile,
    pub tiles: Vec<TileFilm>,
    /// All samples before the current block.
    closed: Part<f32>,
}

impl TileFilm {
    /// No samples yet.
    fn new(tile: Tile, keeps: Keeps) -> Self {
        Self {
            tile,
            sums: Sums::zero(tile.pixels() as usize, keeps),
            tally: Tally::default(),
        }
    }
}

impl PathFilm {
    /// Continues a part of the pixels of `area`, which `tiles` cover.
    pub fn new(area: Tile, tiles: Vec<Tile>, part: Part<f32>) -> Self {
        let (closed, tail) = part.without_tail();
        let film = |tile| match &tail {
            None => TileFilm::new(tile, closed.keeps()),
            Some(sums) => TileFilm {
                tile,
                sums: piece(sums, area, tile),
                tally: Tally::default(),
            },
        };
        Self {
            tiles: tiles.into_iter().map(film).collect(),
            area,
            closed,
        }
    }

    /// One of the same tiles that continues another part.
    pub fn going_on(&self, part: Part<f32>) -> Self {
        let tiles = self.tiles.iter().map(|t| t.tile).collect();
        Self::new(self.area, tiles, part)
    }

    /// Its additional sums of each pixel.
    pub fn keeps(&self) -> Keeps {
        self.closed.keeps()
    }

    /// The index of the first sample of the current block.
    pub fn block_begin(&self) -> u32 {
        self.closed.range().end
    }

    /// The index of the next sample.
    pub fn done(&self) -> u32 {
        self.block_begin() + self.tiles.first().map_or(0, |t| t.sums.samples)
    }

    /// The index at which the film is to be [settled](Self::settle), at most `to`.
    pub fn stop(&self, to: u32) -> u32 {
        self.closed.stop(self.done(), to)
    }

    /// Begins a new block if one ends; returns whether it does.
    pub fn settle(&mut self) -> bool {
        let ends = self.closed.ends_at(self.done());
        if ends {
            self.closed.tally = self.tally();
            self.closed.close(self.sums());
            for t in &mut self.tiles {
                *t = TileFilm::new(t.tile, self.closed.keeps());
            }
        }
        ends
    }

    /// Restarts a tile, after all samples of `closed`.
    pub fn restart(&mut self, tile: usize, closed: Part<f32>) {
        let film = &mut self.tiles[tile];
        *film = TileFilm::new(film.tile, closed.keeps());
        self.closed = closed;
    }

    /// The counters so far.
    fn tally(&self) -> Tally {
        let tiles = self.tiles.iter().map(|t| t.tally);
        tiles.fold(self.closed.tally, Tally::plus)
    }

    /// The sums of the current block: puts each pixel of each tile in its place.
    fn sums(&self) -> Sums<f32> {
        let pixels = self.area.pixels() as usize;
        let mut all = Sums::zero(pixels, self.closed.keeps());
        for film in &self.tiles {
            all.samples = film.sums.samples;
            for (from, to) in rows(film.tile, self.area) {
                all.pixels[to.clone()].copy_from_slice(&film.sums.pixels[from.clone()]);
                all.beside.put(to, &film.sums.beside, from);
            }
        }
        all
    }
}

type Places = std::ops::Range<usize>;

/// The places of the rows of a tile, in the tile and in the area.
fn rows(tile: Tile, area: Tile) -> impl Iterator<Item = (Places, Places)> {
    let width = tile.width as usize;
    (0..tile.height).map(move |y| {
        let from = y as usize * width;
        let to = (tile.y - area.y + y) as usize * area.width as usize + (tile.x - area.x) as usize;
        (from..from + width, to..to + width)
    })
}

/// The pixels of a tile of the area.
fn piece(sums: &Sums<f32>, area: Tile, tile: Tile) -> Sums<f32> {
    let of = |(_, place): (Places, Places)| sums.pixels[place].to_vec();
    let pixels: Vec<Vec<PixelSums<f32>>> = rows(tile, area).map(of).collect();
    Sums {
        samples: sums.samples,
        pixels: pixels.concat(),
        beside: sums.beside.of(rows(tile, area).map(|(_, place)| place)),
    }
}

impl HostFilm for PathFilm {
    type Scalar = f32;

    fn part(&self) -> Part<f32> {
        let mut part = self.closed.with_tail(self.sums());
        part.tally = self.tally();
        part
    }
}
