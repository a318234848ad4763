//! Where the rays of a lens start, and where they go.

use vkpt::reference::camera::lens::{disc_point, lens_pixel, lens_point, lens_sample};
use vkpt::reference::camera::{Lens, camera_direction, eye_sample};
use vkpt::reference::math::{Real, Vec3, dot3, length3};
use vkpt::reference::world::World;
use vkpt::settings::Settings;

use crate::common::render::prepared;

/// Turned, moved away from the origin, and not square.
const TEXT: &str = "screen 64 48\ncamera 3 -6 2 .35 z 20 x 70 y 5\nlens .3 4\nbrdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 2\n";

/// Uniform numbers, by which a test goes over the lens and over a pixel.
fn grid(n: usize) -> impl Iterator<Item = [f64; 4]> {
    let at = move |k: usize| (k as f64 + 0.5) / n as f64;
    (0..n.pow(4)).map(move |i| [i, i / n, i / n.pow(2), i / n.pow(3)].map(|k| at(k % n)))
}

/// A centred square of half the side s becomes the circle of radius s, and areas shrink by π/4: by the map's derivatives, which
/// differences over 1e-5 give to 1e-9.
#[test]
fn the_disc_is_covered_evenly() {
    for [u, v, ..] in grid(24).step_by(24 * 24) {
        let q = |du: f64, dv: f64| disc_point([u + du, v + dv]);
        let [x, y] = q(0.0, 0.0);
        let side = f64::max((2.0 * u - 1.0).abs(), (2.0 * v - 1.0).abs());
        assert!((x.hypot(y) - side).abs() < 1e-15, "{u}, {v}");
        // Where the triangles of the map meet, it has no derivative.
        if ((u - 0.5).abs() - (v - 0.5).abs()).abs() > 1e-3 {
            let d = 1e-5;
            let slope = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|k| (a[k] - b[k]) / (2.0 * d));
            let [a, b] = slope(q(d, 0.0), q(-d, 0.0));
            let [c, e] = slope(q(0.0, d), q(0.0, -d));
            let area = a * e - b * c;
            assert!(
                (area - std::f64::consts::PI).abs() < 1e-6,
                "{u}, {v}: {area}"
            );
        }
    }
}

/// The corners of the square of numbers, and its middle, in f32.
#[test]
fn the_disc_has_no_point_beyond_its_edge_and_no_hole() {
    let last = 1.0 - 2f32.powi(-24);
    for u in [
        [0.0, 0.0],
        [0.0, last],
        [last, 0.0],
        [last, last],
        [0.0, 0.5],
        [0.5, last],
    ] {
        let [x, y] = disc_point(u);
        let r = f64::from(x).hypot(f64::from(y));
        assert!((r - 1.0).abs() < 2e-7, "{u:?}: {r}");
    }
    assert_eq!(disc_point([0.5f32, 0.5]), [0.0, 0.0]);
}

struct Seen<F> {
    world: World<F>,
    lens: Lens<F>,
    focus: f64,
}

fn seen<F: Real>() -> Seen<F> {
    let scene = prepared(TEXT, &Settings::default());
    let world = World::new(&scene);
    let lens = world.lens.expect("a lens");
    let focus = scene.space.length(4.0);
    Seen { world, lens, focus }
}

impl<F: Real> Seen<F> {
    /// The start of the ray through a point of pixel (40, 9), and its direction.
    fn ray(&self, [u, v, a, b]: [f64; 4]) -> (Vec3<F>, Vec3<F>, [F; 2]) {
        let q = disc_point([F::new(u), F::new(v)]);
        let [x, y] = lens_pixel(&self.lens, q, [F::new(a), F::new(b)]);
        let d = camera_direction(&self.world.camera, 40, 9, x, y);
        (lens_point(&self.world.camera, &self.lens, q), d, q)
    }

    /// How far, at most, rays start outside of the lens's plane or beyond its edge, and how far they miss the pinhole's ray in
    /// the plane that is sharp.
    fn departure(&self) -> f64 {
        let camera = &self.world.camera;
        let radius = length3(self.lens.right).f64();
        let mut most = 0.0;
        for numbers in grid(6) {
            let (o, d, _) = self.ray(numbers);
            let off = o - camera.eye;
            let plane = dot3(off, camera.forward).abs().f64();
            let beyond = length3(off).f64() - radius;
            let direct = camera_direction(camera, 40, 9, F::new(numbers[2]), F::new(numbers[3]));
            let to_focus = |d: Vec3<F>| d * (F::new(self.focus) / dot3(d, camera.forward));
            let miss = length3(off + to_focus(d) - to_focus(direct)).f64();
            most = [plane, beyond, miss].into_iter().fold(most, f64::max);
        }
        most
    }
}

/// In units of about the scene's size. Of f32 some 20 roundings of numbers below 4 stay.
#[test]
fn rays_start_on_the_lens_and_meet_the_pinholes_in_the_plane_that_is_sharp() {
    assert!(seen::<f64>().departure() < 1e-14);
    let single = seen::<f32>().departure();
    assert!(single < 20.0 * 4.0 * 2f64.powi(-24), "{single:e}");
    let mut wrong = seen::<f64>();
    wrong.lens.blur *= 1.001;
    assert!(wrong.departure() > 1e-5);
}

/// A point on a ray sees the ray's pixel through the ray's point of the lens.
#[test]
fn points_see_the_pixel_that_sees_them() {
    let seen = seen::<f64>();
    for numbers in grid(5) {
        let (o, d, q) = seen.ray(numbers);
        for t in [1e-3, 0.5, 3.0, 1e4] {
            let s = lens_sample(&seen.world.camera, &seen.lens, q, o + d * t);
            assert_eq!((s.seen, s.column, s.row), (true, 40, 9), "{numbers:?}");
            assert!((s.distance / t - 1.0).abs() < 1e-12 && length3(s.wi + d) < 1e-12);
        }
    }
}

/// A lens of radius 0, which a kernel has that looks for a lens where there is none.
#[test]
fn a_lens_of_radius_0_is_a_pinhole_to_the_bit() {
    let mut seen = seen::<f32>();
    seen.lens = Lens {
        right: Vec3::zero(),
        blur: 0.0,
        up: Vec3::zero(),
    };
    let camera = &seen.world.camera;
    let bits = |v: Vec3<f32>| [v.x, v.y, v.z].map(f32::to_bits);
    for numbers in grid(5) {
        let (o, d, q) = seen.ray(numbers);
        let [a, b] = [numbers[2], numbers[3]].map(|x| x as f32);
        assert_eq!(bits(o), bits(camera.eye));
        assert_eq!(bits(d), bits(camera_direction(camera, 40, 9, a, b)));
        let p = o + d * 1.7;
        let (of_lens, of_pinhole) = (lens_sample(camera, &seen.lens, q, p), eye_sample(camera, p));
        assert_eq!(format!("{of_lens:?}"), format!("{of_pinhole:?}"));
    }
}

#[test]
fn a_scene_whose_lens_has_radius_0_has_none() {
    let text = TEXT.replace("lens .3 4", "lens 0 4");
    assert!(prepared(&text, &Settings::default()).lens.is_none());
}
