//! `--tev`: pictures sent to a viewer, to a missing one, and to ones that misbehave.

use std::io::Read;
use std::net::TcpListener;
use std::time::{Duration, Instant};

use super::viewer::{Packet, open, parse, viewer};
use super::{SCENE, picture};
use crate::cli::program::{Run, folder, words};

#[test]
fn the_last_picture_is_that_of_the_file() {
    let (port, reading) = viewer();
    let folder = folder(SCENE);
    let flags = "--spp 20000 --checkpoint off -o a.exr";
    let line = format!("scene.scn --device cpu-f32 {flags} --tev 127.0.0.1:{port}");
    let run = words(folder.path(), &line);
    assert_eq!(run.code, Some(0), "{}", run.err);
    let packets = reading.join().expect("a viewer").expect("packets");
    assert_eq!(packets[0], Packet::Close("scene.scn".to_owned()));
    let updates = packets
        .iter()
        .filter(|p| matches!(p, Packet::Update { .. }));
    assert!(updates.count() >= 2, "one under way, and the last");
    let open = open(&packets);
    let (size, pixels) = &open["scene.scn"];
    assert_eq!((open.len(), *size), (1, [16, 12]));
    assert!(
        *pixels == picture(&folder.path().join("a.exr")).rgb,
        "other pixels"
    );
    // Not a bit is another than without.
    let plain = words(
        folder.path(),
        &format!(
            "scene.scn --device cpu-f32 {}",
            flags.replace("a.exr", "b.exr")
        ),
    );
    assert_eq!(plain.code, Some(0), "{}", plain.err);
    let bytes = |name| std::fs::read(folder.path().join(name)).expect("a picture");
    assert!(bytes("a.exr") == bytes("b.exr"), "other bits");
}

/// A rendering of a large picture, too large for one write to a connection.
fn large(flags: &str) -> (Run, Duration) {
    let folder = folder(SCENE);
    let line = "scene.scn --device cpu-f32 --size 1600x1200 --spp 1 -o a.hdr --quiet";
    let start = Instant::now();
    let run = words(folder.path(), &format!("{line} {flags}"));
    assert!(folder.path().join("a.hdr").exists(), "{}", run.err);
    (run, start.elapsed())
}

/// One warning, and a picture all the same.
fn warns_once(run: &Run) {
    assert_eq!(run.code, Some(0), "{}", run.err);
    let warnings = run
        .err
        .matches("warning: cannot send pictures to tev at 127.0.0.1:")
        .count();
    assert_eq!((warnings, run.err.lines().count()), (1, 1), "{}", run.err);
    assert!(run.err.contains("the rendering continues"), "{}", run.err);
}

#[test]
fn bands_of_a_large_picture_make_all_of_it() {
    let (port, reading) = viewer();
    let (run, _) = large(&format!("--tev 127.0.0.1:{port}"));
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let packets = reading.join().expect("a viewer").expect("packets");
    let open = open(&packets);
    let (size, pixels) = &open["scene.scn"];
    assert_eq!(*size, [1600, 1200]);
    let lit = pixels.iter().filter(|pixel| pixel[0] > 0.0).count();
    assert!(lit > pixels.len() / 10, "{lit}");
}

#[test]
fn without_a_viewer_it_renders_all_the_same() {
    // A port that was free a moment ago.
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = listener.local_addr().expect("an address").port();
    drop(listener);
    warns_once(&large(&format!("--tev 127.0.0.1:{port}")).0);
}

#[test]
fn a_viewer_that_hangs_up_is_done_without() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = listener.local_addr().expect("an address").port();
    let viewer = std::thread::spawn(move || {
        let (mut stream, _) = listener.accept().expect("a client");
        // Only some of the first picture.
        let mut bytes = [0; 1000];
        stream.read_exact(&mut bytes).expect("bytes");
    });
    warns_once(&large(&format!("--tev 127.0.0.1:{port}")).0);
    viewer.join().expect("a viewer");
}

#[test]
fn a_viewer_that_reads_nothing_delays_nothing_for_long() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = listener.local_addr().expect("an address").port();
    let (run, took) = large(&format!("--tev 127.0.0.1:{port}"));
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert!(took < Duration::from_secs(20), "{took:?}");
}

#[test]
fn an_invalid_address_is_refused() {
    let folder = folder(SCENE);
    let run = words(folder.path(), "scene.scn --tev localhost:x");
    assert_eq!(run.code, Some(2), "{}", run.err);
    assert!(
        run.err.contains("must be a host and an optional port"),
        "{}",
        run.err
    );
}

/// Planted errors: the viewer of these tests takes none of them for a packet.
#[test]
fn a_wrong_packet_is_found() {
    let (port, reading) = viewer();
    let folder = folder(SCENE);
    let line = "scene.scn --device cpu-f32 --size 2x1 --spp 1 -o a.exr --tev";
    words(folder.path(), &format!("{line} 127.0.0.1:{port}"));
    let packets = reading.join().expect("a viewer").expect("packets");
    assert!(matches!(packets.last(), Some(Packet::Update { .. })));
    // A right one by hand: the last pixel's blue is 2.
    let mut right = vec![0, 0, 0, 0, 6, 0, b'a', 0, 3, 0, 0, 0];
    right.extend(b"R\0G\0B\0");
    right.extend([0i32, 0, 2, 1].iter().flat_map(|n| n.to_le_bytes()));
    right.extend([0i64, 1, 2, 3, 3, 3].iter().flat_map(|n| n.to_le_bytes()));
    right.extend(
        [0f32, 0., 0., 0., 1., 2.]
            .iter()
            .flat_map(|n| n.to_le_bytes()),
    );
    let decoded = |mut packet: Vec<u8>| {
        let length = (packet.len() as u32).to_le_bytes();
        packet[..4].copy_from_slice(&length);
        parse(&packet)
    };
    let Ok(Packet::Update { values, .. }) = decoded(right.clone()) else {
        panic!("{:?}", decoded(right));
    };
    assert_eq!(values, [[0., 0.], [0., 1.], [0., 2.]]);
    assert!(parse(&right).is_err(), "another length than it states");
    let cut = right[..right.len() - 4].to_vec();
    assert!(decoded(cut).is_err(), "a value too few");
    let mut long = right.clone();
    long.push(0);
    assert!(decoded(long).is_err(), "a byte too many");
    for (at, wrong) in [(4, 7), (5, 9), (8, 4), (26, 3), (74, 4)] {
        let mut packet = right.clone();
        packet[at] = wrong;
        assert!(decoded(packet).is_err(), "{wrong} at {at}");
    }
}
