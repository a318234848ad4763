//! The order among hits: least (t, shape, primitive), in any order of tests; targets and limits.

use vkpt::prepared::NONE;
use vkpt::reference::math::{Vec3, vec3};
use vkpt::reference::shape::{
    Cuboid, FAR, Hit, Ray, Sphere, Target, Triangle, closer, nearest_boxes, nearest_spheres,
    nearest_triangles, no_hit,
};

const UP: Vec3<f64> = Vec3 {
    x: 0.0,
    y: 0.0,
    z: 1.0,
};

fn below() -> Ray<f64> {
    Ray::new(vec3(0.25, 0.25, -1.0), UP)
}

/// A box, a ball and a triangle, all first met at z = 0.
fn box_on_plane(shape: u32) -> [Cuboid<f64>; 1] {
    [Cuboid {
        lo: Vec3::zero(),
        hi: Vec3::one(),
        shape,
    }]
}
fn ball_on_plane(shape: u32) -> [Sphere<f64>; 1] {
    [Sphere {
        centre: vec3(0.25, 0.25, 1.0),
        radius: 1.0,
        shape,
    }]
}
fn sheet(shape: u32, z: f64) -> Triangle<f64> {
    let v = [vec3(0.0, 0.0, z), vec3(1.0, 0.0, z), vec3(0.0, 1.0, z)];
    Triangle { v, shape }
}

#[test]
fn at_equal_distance_the_first_shape_wins_in_any_order_of_search() {
    for (box_shape, ball_shape, mesh_shape) in [(0, 1, 2), (2, 0, 1), (1, 2, 0)] {
        let skip = Target::none();
        let mesh = [sheet(mesh_shape, 0.0), sheet(mesh_shape, 0.0)];
        let search = |order: [u32; 3]| {
            let mut best = no_hit(FAR);
            for kind in order {
                best = match kind {
                    0 => nearest_boxes(&box_on_plane(box_shape), below(), skip, best),
                    1 => nearest_spheres(&ball_on_plane(ball_shape), below(), skip, best),
                    _ => nearest_triangles(&mesh, below(), skip, best),
                };
            }
            best
        };
        for order in [
            [0, 1, 2],
            [0, 2, 1],
            [1, 0, 2],
            [1, 2, 0],
            [2, 0, 1],
            [2, 1, 0],
        ] {
            let best = search(order);
            assert_eq!((best.t, best.shape), (1.0, 0));
        }
    }
    // Of two equal triangles the first.
    let mesh = [sheet(0, 0.0), sheet(0, 0.0)];
    assert_eq!(
        nearest_triangles(&mesh, below(), Target::none(), no_hit(FAR)).prim,
        0
    );
}

#[test]
fn exactly_the_target_is_passed_over() {
    let mesh = [sheet(0, 0.0), sheet(0, 2.0)];
    let one = Target { shape: 0, prim: 0 };
    assert_eq!(nearest_triangles(&mesh, below(), one, no_hit(FAR)).prim, 1);
    let solid = Target {
        shape: 3,
        prim: NONE,
    };
    let boxes = box_on_plane(3);
    assert_eq!(
        nearest_boxes(&boxes, below(), solid, no_hit(FAR)).shape,
        NONE
    );
    assert_eq!(
        nearest_triangles(&mesh, below(), solid, no_hit(FAR)).prim,
        0
    );
}

#[test]
fn a_limit_is_not_a_hit() {
    let skip = Target::none();
    let before = |t: f64| nearest_boxes(&box_on_plane(0), below(), skip, no_hit(t)).shape == 0;
    assert!(before(1.0 + 1e-15));
    assert!(!before(1.0));
}

#[test]
fn the_order_is_lexicographic() {
    let at = |t: f64, shape, prim| Hit {
        t,
        shape,
        prim,
        uv: [0.0; 2],
    };
    let hits = [at(1.0, 0, 0), at(1.0, 0, 1), at(1.0, 1, 0), at(2.0, 0, 0)];
    for (i, a) in hits.iter().enumerate() {
        for (k, b) in hits.iter().enumerate() {
            assert_eq!(closer(a.t, a.shape, a.prim, *b), i < k);
        }
    }
}
