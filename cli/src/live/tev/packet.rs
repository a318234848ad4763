//! The packets of tev, little-endian, as tev reads them (<https://github.com/Tom94/tev>, `include/tev/Ipc.h`): the total
//! length, a byte for the kind, and the fields in order; texts end with 0.

use std::ops::Range;

use vkpt::film::Film;

const CLOSE: u8 = 2;
const CREATE: u8 = 4;
/// With any number of channels, each with its place in the data.
const UPDATE: u8 = 6;

/// In the order of a film's pixels.
const CHANNELS: [&str; 3] = ["R", "G", "B"];

/// The approximate number of bytes of pixels in a packet.
const BAND: usize = 1 << 20;

/// Closes the picture of that name, if any.
pub fn close(name: &str) -> Vec<u8> {
    packet(CLOSE, |body| text(body, name))
}

/// Opens a black picture.
pub fn create(name: &str, film: &Film) -> Vec<u8> {
    packet(CREATE, |body| {
        body.push(u8::from(true));
        text(body, name);
        whole(body, &[film.width, film.height]);
        channels(body);
    })
}

/// All pixels, a band of rows in each packet.
pub fn updates(name: &str, film: &Film) -> impl Iterator<Item = Vec<u8>> {
    let row = 12 * film.width as usize;
    let rows = (BAND / row).max(1) as u32;
    let tops = (0..film.height).step_by(rows as usize);
    tops.map(move |top| update(name, film, top..(top + rows).min(film.height)))
}

/// The pixels of some rows.
fn update(name: &str, film: &Film, rows: Range<u32>) -> Vec<u8> {
    packet(UPDATE, |body| {
        // Do not bring the picture to the front.
        body.push(u8::from(false));
        text(body, name);
        channels(body);
        whole(body, &[0, rows.start, film.width, rows.end - rows.start]);
        // For each channel, the offset of its first value, and the stride to the next.
        let places = [0i64, 1, 2].into_iter().chain([3; 3]);
        body.extend(places.flat_map(i64::to_le_bytes));
        for y in rows {
            let values = film.row(y as usize).as_flattened().iter();
            body.extend(values.flat_map(|value| value.to_le_bytes()));
        }
    })
}

fn packet(kind: u8, fill: impl FnOnce(&mut Vec<u8>)) -> Vec<u8> {
    let mut packet = vec![0, 0, 0, 0, kind];
    fill(&mut packet);
    // A band of a film is far below 4 GiB.
    let length = packet.len() as u32;
    packet[..4].copy_from_slice(&length.to_le_bytes());
    packet
}

fn text(body: &mut Vec<u8>, text: &str) {
    body.extend(text.bytes().filter(|byte| *byte != 0));
    body.push(0);
}

fn whole(body: &mut Vec<u8>, numbers: &[u32]) {
    body.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
}

fn channels(body: &mut Vec<u8>) {
    whole(body, &[CHANNELS.len() as u32]);
    CHANNELS.iter().for_each(|name| text(body, name));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_of_a_picture_of_one_pixel() {
        let film = Film {
            width: 1,
            height: 1,
            rgb: vec![[1.0, 0.5, -2.0]],
        };
        assert_eq!(close("ab"), b"\x08\0\0\0\x02ab\0");
        let names = b"\x03\0\0\0R\0G\0B\0";
        let size = b"\x01\0\0\0\x01\0\0\0";
        let expected = [&b"\x1b\0\0\0\x04\x01ab\0"[..], size, names].concat();
        assert_eq!(create("ab", &film), expected);
        let head = b"\x5f\0\0\0\x06\0ab\0";
        let place = b"\0\0\0\0\0\0\0\0\x01\0\0\0\x01\0\0\0";
        let offsets = b"\0\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0\x02\0\0\0\0\0\0\0";
        let strides = b"\x03\0\0\0\0\0\0\0".repeat(3);
        let pixel = b"\0\0\x80\x3f\0\0\0\x3f\0\0\0\xc0";
        let expected = [&head[..], names, place, offsets, &strides, pixel].concat();
        let all: Vec<_> = updates("ab", &film).collect();
        assert_eq!(all, [expected]);
    }

    #[test]
    fn large_pictures_go_in_bands() {
        let film = Film {
            width: 4000,
            height: 50,
            rgb: vec![[0.0; 3]; 200_000],
        };
        let lengths: Vec<_> = updates("a", &film).map(|packet| packet.len()).collect();
        // 21 rows of 48,000 bytes are about a mebibyte; 82 bytes are the header.
        let rows = |rows: usize| rows * 48_000 + 82;
        assert_eq!(lengths, [rows(21), rows(21), rows(8)]);
    }
}
