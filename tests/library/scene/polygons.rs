//! Polygons of any shape: their triangles cover exactly the polygon.

use std::fmt::Write;
use std::path::Path;

use glam::{DQuat, DVec2, DVec3};
use vkpt::scene::{MeshError, MeshFile, parse_mesh};

use super::fuzz::Random;

/// The mesh of one polygon.
fn cut(corners: &[DVec3]) -> Result<MeshFile, MeshError> {
    let mut text = String::new();
    let mut face = String::from("f");
    for (i, p) in corners.iter().enumerate() {
        writeln!(text, "v {} {} {}", p.x, p.y, p.z).expect("a string");
        write!(face, " {}", i + 1).expect("a string");
    }
    parse_mesh((text + &face).as_bytes(), Path::new("mesh.obj"))
}

/// ½ Σ pᵢ × pᵢ₊₁ (the shoelace formula).
fn area(corners: &[DVec2]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(|(a, b)| a.perp_dot(*b))
        .sum::<f64>()
        / 2.0
}

/// Whether `p` lies in a polygon: a ray from it to +x crosses an odd number of sides (Franklin's pnpoly).
fn is_inside(corners: &[DVec2], p: DVec2) -> bool {
    let next = corners.iter().cycle().skip(1);
    let crossed = corners.iter().zip(next).filter(|(a, b)| {
        (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x
    });
    crossed.count() % 2 == 1
}

/// The errors of the triangles of a polygon in the plane z = 0; they must be wound as it is, lie in it, and have its
/// area.
fn fault(corners: &[DVec2], triangles: &[[u32; 3]]) -> Option<String> {
    let whole = area(corners);
    let mut sum = 0.0;
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| corners[i as usize]);
        let part = area(&[a, b, c]);
        sum += part;
        // Of a sliver the middle lies on a side.
        if part.abs() > 1e-9 && !is_inside(corners, (a + b + c) / 3.0) {
            return Some(format!("{triangle:?} lies outside"));
        }
        if part * whole < -1e-9 {
            return Some(format!("{triangle:?} is wound the other way"));
        }
    }
    ((sum - whole).abs() > 1e-9 * whole.abs()).then(|| format!("area {sum} for {whole}"))
}

fn flat(corners: &[[f64; 2]]) -> Vec<DVec2> {
    corners.iter().copied().map(DVec2::from).collect()
}

/// Polygons with corners that a fan does not reach: an L, a comb, a spiral, a star, a bridge to a hole, corners on a line.
fn shapes() -> Vec<Vec<DVec2>> {
    let star = (0..10).map(|i| {
        let radius = if i % 2 == 0 { 2.0 } else { 0.5 };
        radius * DVec2::from_angle(f64::from(i) * 36_f64.to_radians())
    });
    vec![
        flat(&[[2., 0.], [2., 1.], [1., 1.], [1., 2.], [0., 2.], [0., 0.]]),
        flat(&[
            [0., 0.],
            [7., 0.],
            [7., 3.],
            [6., 3.],
            [6., 1.],
            [5., 1.],
            [5., 3.],
            [4., 3.],
            [4., 1.],
            [3., 1.],
            [3., 3.],
            [2., 3.],
            [2., 1.],
            [1., 1.],
            [1., 3.],
            [0., 3.],
        ]),
        flat(&[
            [0., 0.],
            [5., 0.],
            [5., 5.],
            [1., 5.],
            [1., 2.],
            [3., 2.],
            [3., 3.],
            [2., 3.],
            [2., 4.],
            [4., 4.],
            [4., 1.],
            [0., 1.],
        ]),
        star.collect(),
        flat(&[
            [0., 0.],
            [4., 0.],
            [4., 4.],
            [0., 4.],
            [0., 0.],
            [1., 1.],
            [1., 3.],
            [3., 3.],
            [3., 1.],
            [1., 1.],
        ]),
        flat(&[
            [0., 0.],
            [1., 0.],
            [2., 0.],
            [3., 0.],
            [3., 3.],
            [2., 3.],
            [2., 1.],
            [1., 1.],
            [1., 3.],
            [0., 3.],
        ]),
    ]
}

#[test]
fn the_triangles_cover_the_polygon_whichever_corner_comes_first() {
    for mut corners in shapes() {
        for mirrored in [false, true] {
            if mirrored {
                corners.reverse();
            }
            for first in 0..corners.len() {
                corners.rotate_left(1);
                let mesh = cut(&corners.iter().map(|p| p.extend(0.0)).collect::<Vec<_>>())
                    .expect("a polygon");
                assert_eq!(
                    fault(&corners, &mesh.triangles),
                    None,
                    "{corners:?} from {first}"
                );
                // Neighbours of a solid share whole sides: no corner on a straight side is omitted.
                let used: std::collections::HashSet<u32> =
                    mesh.triangles.as_flattened().iter().copied().collect();
                let places = corners.iter().map(|p| p.to_array().map(f64::to_bits));
                let places: std::collections::HashSet<_> = places.collect();
                assert!(
                    used.len()
                        >= places.len().min(corners.len())
                            - usize::from(corners.len() > places.len())
                );
            }
        }
    }
}

/// A fan about the first corner of the L, as it was once cut: area 3.25 for 3, and a triangle outside.
#[test]
fn the_comparison_notices_a_fan() {
    let corners = &shapes()[0];
    let fan: Vec<_> = (2..6).map(|i| [0, i - 1, i]).collect();
    assert!(fault(corners, &fan).is_some());
    let whole = cut(&corners.iter().map(|p| p.extend(0.0)).collect::<Vec<_>>()).expect("a polygon");
    assert!(fault(corners, &whole.triangles[1..]).is_some());
}

/// Corners at random radii about a middle make a polygon that does not cross itself. It is turned to any plane.
#[test]
fn stars_of_any_shape_in_any_plane() {
    let mut random = Random(17);
    let mut unit = move || random.below(1 << 20) as f64 / f64::from(1 << 20);
    for _ in 0..500 {
        let count = 4 + (unit() * 12.0) as usize;
        let step = std::f64::consts::TAU / count as f64;
        let corner = |i: usize, r: f64| r * DVec2::from_angle(step * i as f64);
        let corners: Vec<DVec2> = (0..count).map(|i| corner(i, 0.05 + unit())).collect();
        let turn = DQuat::from_euler(
            glam::EulerRot::XYZ,
            6.0 * unit(),
            6.0 * unit(),
            6.0 * unit(),
        );
        let place = DVec3::new(unit(), unit(), unit()) * 3.0;
        let turned: Vec<DVec3> = corners
            .iter()
            .map(|p| place + turn * p.extend(0.0))
            .collect();
        let mesh = cut(&turned).expect("a polygon");
        assert_eq!(fault(&corners, &mesh.triangles), None, "{corners:?}");
    }
}

#[test]
fn polygons_that_cross_themselves_are_refused() {
    let pentagram: Vec<DVec2> = (0..5)
        .map(|i| DVec2::from_angle(f64::from(2 * i) * 72_f64.to_radians()))
        .collect();
    let rows = [
        flat(&[[0., 0.], [1., 1.], [1., 0.], [0., 1.]]),
        flat(&[[0., 0.], [3., 2.], [3., 0.], [0., 1.]]),
        // Two lobes that meet in a corner, wound against each other.
        flat(&[
            [0., 0.],
            [1., 1.],
            [1., -1.],
            [0., 0.],
            [-1., 2.],
            [-1., -1.],
        ]),
        // Around its middle twice.
        pentagram,
    ];
    for corners in rows {
        for turn in [
            DQuat::IDENTITY,
            DQuat::from_rotation_x(0.7),
            DQuat::from_rotation_y(1.9),
        ] {
            let turned: Vec<DVec3> = corners.iter().map(|p| turn * p.extend(0.0)).collect();
            let error = cut(&turned).expect_err("crosses itself").to_string();
            assert!(error.contains("is a face that crosses itself"), "{error}");
        }
    }
}

/// Polygons without an area keep their behaviour: no light meets them.
#[test]
fn polygons_without_an_area_and_bent_ones_are_read() {
    let rows = [
        vec![DVec3::ZERO; 4],
        vec![DVec3::ZERO, DVec3::X, 2.0 * DVec3::X, DVec3::X],
        vec![DVec3::ZERO, DVec3::X, DVec3::ZERO, DVec3::X, DVec3::ZERO],
        // A saddle.
        vec![DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.8), DVec3::Y],
        vec![DVec3::ZERO, DVec3::X, DVec3::new(0.1, 0.1, 0.3), DVec3::Y],
    ];
    for corners in rows {
        let mesh = cut(&corners).expect("a polygon");
        assert_eq!(mesh.triangles.len(), corners.len() - 2, "{corners:?}");
    }
}

/// Scales from the smallest that single precision represents to the largest.
#[test]
fn of_any_size() {
    for exponent in [-120, -60, 0, 60, 120] {
        let scale = 2_f64.powi(exponent);
        let corners: Vec<DVec3> = shapes()[1].iter().map(|p| scale * p.extend(0.0)).collect();
        let mesh = cut(&corners).expect("a polygon");
        assert_eq!(fault(&shapes()[1], &mesh.triangles), None, "2^{exponent}");
    }
}
