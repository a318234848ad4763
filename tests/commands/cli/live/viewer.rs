//! A small viewer that speaks tev's protocol, written from its description alone: <https://github.com/Tom94/tev>.

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::net::{TcpListener, TcpStream};
use std::thread::JoinHandle;

/// A packet, as tev reads it.
#[derive(Clone, Debug, PartialEq)]
pub enum Packet {
    Close(String),
    Create {
        name: String,
        size: [i32; 2],
        channels: Vec<String>,
    },
    Update {
        name: String,
        /// Left, top, width and height.
        area: [i32; 4],
        channels: Vec<String>,
        /// The values of the area, for each channel.
        values: Vec<Vec<f32>>,
    },
}

/// A packet's fields, one after the other.
struct Fields<'a>(&'a [u8]);

impl Fields<'_> {
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], String> {
        let (bytes, rest) = self.0.split_first_chunk().ok_or("cut off")?;
        self.0 = rest;
        Ok(*bytes)
    }

    fn flag(&mut self) -> Result<bool, String> {
        match self.bytes()? {
            [0] => Ok(false),
            [1] => Ok(true),
            [other] => Err(format!("{other} is no flag")),
        }
    }

    fn int(&mut self) -> Result<i32, String> {
        self.bytes().map(i32::from_le_bytes)
    }

    fn text(&mut self) -> Result<String, String> {
        let end = self.0.iter().position(|b| *b == 0).ok_or("no end")?;
        let text = String::from_utf8(self.0[..end].to_vec());
        self.0 = &self.0[end + 1..];
        text.map_err(|e| e.to_string())
    }

    fn texts(&mut self) -> Result<Vec<String>, String> {
        (0..self.int()?).map(|_| self.text()).collect()
    }

    fn longs(&mut self, count: usize) -> Result<Vec<usize>, String> {
        let long = |bytes| usize::try_from(i64::from_le_bytes(bytes));
        let all = (0..count).map(|_| long(self.bytes()?).map_err(|e| e.to_string()));
        all.collect()
    }
}

/// The contents of a whole packet.
pub fn parse(packet: &[u8]) -> Result<Packet, String> {
    let mut fields = Fields(packet);
    let length = u32::from_le_bytes(fields.bytes()?);
    if length as usize != packet.len() {
        return Err(format!(
            "{length} bytes are announced, and {} are there",
            packet.len()
        ));
    }
    let parsed = match fields.bytes()? {
        [2] => Packet::Close(fields.text()?),
        [4] => {
            fields.flag()?;
            Packet::Create {
                name: fields.text()?,
                size: [fields.int()?, fields.int()?],
                channels: fields.texts()?,
            }
        }
        [6] => update(&mut fields)?,
        [other] => return Err(format!("unknown kind {other}")),
    };
    match fields.0 {
        [] => Ok(parsed),
        rest => Err(format!("{} bytes too many", rest.len())),
    }
}

fn update(fields: &mut Fields) -> Result<Packet, String> {
    fields.flag()?;
    let name = fields.text()?;
    let channels = fields.texts()?;
    let area = [fields.int()?, fields.int()?, fields.int()?, fields.int()?];
    let pixels = usize::try_from(area[2]).map_err(|e| e.to_string())? * area[3] as usize;
    let offsets = fields.longs(channels.len())?;
    let strides = fields.longs(channels.len())?;
    let steps = pixels.checked_sub(1).ok_or("no pixels")?;
    let floats = fields
        .0
        .chunks_exact(4)
        .map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let floats: Vec<f32> = floats.collect();
    let last = |(offset, stride): (&usize, &usize)| offset + steps * stride + 1;
    let wanted = offsets.iter().zip(&strides).map(last).max().unwrap_or(0);
    if 4 * wanted != fields.0.len() {
        return Err(format!("{} bytes of {wanted} values", fields.0.len()));
    }
    fields.0 = &[];
    let places = offsets.iter().zip(&strides);
    let values = places.map(|(at, by)| (0..pixels).map(|i| floats[at + i * by]).collect());
    Ok(Packet::Update {
        name,
        area,
        values: values.collect(),
        channels,
    })
}

/// Reads packets until the connection ends.
pub fn read(mut stream: TcpStream) -> io::Result<Vec<Packet>> {
    let mut all = Vec::new();
    loop {
        let mut length = [0; 4];
        match stream.read_exact(&mut length) {
            Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => return Ok(all),
            read => read?,
        }
        let mut packet = length.to_vec();
        packet.resize(u32::from_le_bytes(length) as usize, 0);
        stream.read_exact(&mut packet[4..])?;
        all.push(parse(&packet).map_err(io::Error::other)?);
    }
}

/// A viewer at a free port, and all that it receives until its only client disconnects.
pub fn viewer() -> (u16, JoinHandle<io::Result<Vec<Packet>>>) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = listener.local_addr().expect("an address").port();
    let reading = std::thread::spawn(move || read(listener.accept()?.0));
    (port, reading)
}

/// The pictures that are open in the end: width, height and pixels by name.
pub fn open(packets: &[Packet]) -> BTreeMap<String, ([i32; 2], Vec<[f32; 3]>)> {
    let mut open = BTreeMap::new();
    for packet in packets {
        match packet {
            Packet::Close(name) => drop(open.remove(name)),
            Packet::Create {
                name,
                size,
                channels,
            } => {
                assert_eq!(channels, &["R", "G", "B"]);
                let black = vec![[0.0; 3]; (size[0] * size[1]) as usize];
                assert!(
                    open.insert(name.clone(), (*size, black)).is_none(),
                    "{name} twice"
                );
            }
            Packet::Update {
                name,
                area,
                channels,
                values,
            } => {
                assert_eq!(channels, &["R", "G", "B"]);
                let ([width, _], pixels) = open.get_mut(name).expect("an open picture");
                let [left, top, wide, high] = *area;
                for i in 0..wide * high {
                    let at = (top + i / wide) * *width + left + i % wide;
                    pixels[at as usize] = [0, 1, 2].map(|c| values[c][i as usize]);
                }
            }
        }
    }
    open
}
