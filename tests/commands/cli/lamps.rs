//! Meshes of known area as lamps that fill the picture: its mean is their share of it, a closed form.

use super::program::{folder, words};
use super::rendering::read_exr;

/// The mean of the picture of a lamp in the square 0..2, which the camera sees exactly.
fn mean(file: &str, content: &[u8]) -> f64 {
    let scene = format!("screen 64 64\ncamera 1 1 10 0.1\nlight 1 1 1\nmesh {file} 0 0 0 1\n");
    let folder = folder(&scene);
    std::fs::write(folder.path().join(file), content).expect("a mesh");
    let line = "scene.scn --device cpu-f32 --spp 4 --quiet -o a.exr";
    let ran = words(folder.path(), line);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let values = read_exr(&folder.path().join("a.exr")).rgb;
    let values = values.as_flattened();
    values.iter().map(|&x| f64::from(x)).sum::<f64>() / values.len() as f64
}

const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n\
    element face 1\nproperty list uchar int vertex_indices\nend_header\n";

/// An L of area 3 in the square of area 4, from each of its corners; sides lie between pixels, so that all samples agree.
#[test]
fn an_l_fills_three_quarters_whichever_corner_comes_first() {
    let corners = ["2 0 0", "2 1 0", "1 1 0", "1 2 0", "0 2 0", "0 0 0"];
    let vertices = |word: &str| corners.map(|p| format!("{word}{p}\n")).concat();
    for first in 0..6 {
        let order: Vec<usize> = (0..6).map(|i| (first + i) % 6).collect();
        let list = |base: usize| {
            let words: Vec<_> = order.iter().map(|i| (i + base).to_string()).collect();
            words.join(" ")
        };
        let obj = format!("{}f {}\n", vertices("v "), list(1));
        assert_eq!(mean("l.obj", obj.as_bytes()), 0.75, "{obj}");
        let ply = format!("{PLY}{}6 {}\n", vertices(""), list(0));
        assert_eq!(mean("l.ply", ply.as_bytes()), 0.75, "{ply}");
    }
}

/// The square itself: 1; without one of its triangles: half, except for the pixels on the diagonal. So the mean shows which.
#[test]
fn a_square_fills_all_and_a_triangle_half() {
    let square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";
    assert_eq!(
        mean("a.obj", format!("{square}f 1 2 3 4\n").as_bytes()),
        1.0
    );
    let half = mean("a.obj", format!("{square}f 1 2 3\n").as_bytes());
    assert!((half - 0.5).abs() < 0.02, "{half}");
}
