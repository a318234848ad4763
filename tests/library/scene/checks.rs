//! Requirements on a transmissive mesh.

use glam::{DQuat, DVec3};
use vkpt::scene::{Edges, Mesh, edges, flip, open_edges, signed_volume};

/// A box of sides 1, 2, 3 with its near corner at `corner`, wound so that its normals point out.
fn cuboid(corner: DVec3) -> Mesh {
    let sides = DVec3::new(1.0, 2.0, 3.0);
    let vertex = |i: usize| {
        corner + sides * DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64)
    };
    // Four corners a face, anticlockwise from outside; bit 0 is x, bit 1 y, bit 2 z.
    let faces = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    Mesh {
        path: "box.ply".into(),
        files: Vec::new(),
        positions: (0..8).map(vertex).collect(),
        normals: None,
        triangles: faces
            .iter()
            .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]])
            .collect(),
        translate: DVec3::ZERO,
        scale: 1.0,
        rotate: DQuat::IDENTITY,
    }
}

#[test]
fn a_box_is_closed_and_has_its_volume_wherever_it_stands() {
    for corner in [DVec3::ZERO, DVec3::new(-0.5, -1.0, -1.5), DVec3::splat(1e6)] {
        let mesh = cuboid(corner);
        assert_eq!(edges(&mesh), Edges::default());
        assert!((signed_volume(&mesh) - 6.0).abs() < 1e-9, "{corner}");
    }
}

#[test]
fn flipped_it_is_inside_out() {
    let mut mesh = cuboid(DVec3::ONE);
    flip(&mut mesh);
    assert!((signed_volume(&mesh) + 6.0).abs() < 1e-12);
    assert_eq!(edges(&mesh), Edges::default());
}

#[test]
fn a_lost_face_leaves_its_edges_open() {
    let mut mesh = cuboid(DVec3::ZERO);
    mesh.triangles.truncate(11);
    assert_eq!(
        (edges(&mesh), open_edges(&mesh)),
        (Edges { open: 3, torn: 0 }, 3)
    );
    mesh.triangles.truncate(10);
    assert_eq!(open_edges(&mesh), 4);
    mesh.triangles.clear();
    assert_eq!((open_edges(&mesh), signed_volume(&mesh)), (0, 0.0));
}

#[test]
fn a_triangle_wound_the_other_way_tears_its_edges() {
    let mut mesh = cuboid(DVec3::ZERO);
    mesh.triangles[5].swap(0, 1);
    assert_eq!(edges(&mesh), Edges { open: 0, torn: 3 });
}

#[test]
fn vertices_at_one_place_are_one_and_slivers_do_not_count() {
    let mut mesh = cuboid(DVec3::ZERO);
    // Each triangle gets its own vertices, and every other zero becomes negative.
    let corners: Vec<usize> = mesh
        .triangles
        .iter()
        .flatten()
        .map(|&i| i as usize)
        .collect();
    let negative_zero = |(n, p): (usize, DVec3)| {
        if n % 2 == 0 {
            p
        } else {
            p + p.map(|x| if x == 0.0 { -0.0 } else { 0.0 })
        }
    };
    mesh.positions = corners
        .iter()
        .map(|&i| mesh.positions[i])
        .enumerate()
        .map(negative_zero)
        .collect();
    mesh.triangles = (0..12).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    assert_eq!(edges(&mesh), Edges::default());
    mesh.triangles.push([0, 0, 7]);
    assert_eq!(edges(&mesh), Edges::default());
}
