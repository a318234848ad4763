//! Twins of `shaders/camera/`.

use vkpt::layout::GpuStruct;
use vkpt::prepared::device;
use vkpt::reference::camera::lens::{disc_point, lens_pixel, lens_point, lens_sample};
use vkpt::reference::camera::{
    Camera, EyeSample, Lens, camera_direction, eye_importance, eye_sample,
};
use vkpt::reference::math::Vec3;

use super::harness::{In, Out, Rng, Row, Twin};

/// A 640 × 480 or an 8192 × 8191 picture, seen by a camera that is turned.
const GLSL: &str = "
    Camera camera;
    camera.eye = in_vec3();
    camera.right = in_vec3();
    camera.up = in_vec3();
    camera.forward = in_vec3();
    camera.width = in_u();
    camera.height = in_u();";

fn read_camera(i: &mut In) -> Camera<f32> {
    Camera {
        eye: i.vec3(),
        right: i.vec3(),
        up: i.vec3(),
        forward: i.vec3(),
        width: i.u(),
        height: i.u(),
    }
}

const LENS: &str = "
    Lens lens;
    lens.right = camera.right * in_f();
    lens.up = camera.up * in_f();
    lens.blur = in_f();";

fn read_lens(camera: &Camera<f32>, i: &mut In) -> Lens<f32> {
    Lens {
        right: camera.right * i.f(),
        up: camera.up * i.f(),
        blur: i.f(),
    }
}

const WRITE: &str = "
    out_vec3(s.wi); out_f(s.distance); out_b(s.seen); out_u(s.column); out_u(s.row); out_f(s.importance);";

fn write(s: EyeSample<f32>, o: &mut Out) {
    o.vec3(s.wi);
    o.f(s.distance);
    o.b(s.seen);
    o.u(s.column);
    o.u(s.row);
    o.f(s.importance);
}

const RIGHT: Vec3<f32> = Vec3 {
    x: 0.264,
    y: -0.07,
    z: 0.01,
};
const UP: Vec3<f32> = Vec3 {
    x: -0.33,
    y: -0.189,
    z: 0.925,
};
const FORWARD: Vec3<f32> = Vec3 {
    x: -0.803,
    y: -0.458,
    z: -0.381,
};

fn camera(size: [u32; 2]) -> Row {
    let axes = Row::new()
        .vec3(Vec3::zero())
        .vec3(RIGHT)
        .vec3(UP)
        .vec3(FORWARD);
    axes.u(size[0]).u(size[1])
}

/// A point of the picture, or somewhere: seen, or outside the picture.
fn seen(r: &mut Rng) -> Vec3<f32> {
    let aside = RIGHT * r.range(-1.2, 1.2) + UP * r.range(-1.2, 1.2);
    (FORWARD + aside) * r.log_range(1e-6, 1e6)
}

pub fn twins() -> Vec<Twin> {
    vec![eye(), direction(), disc(), lens()]
}

fn eye() -> Twin {
    let point = |at: Vec3<f32>| camera([640, 480]).vec3(at);
    Twin::new("eye_sample", "camera/eye")
        .also(&["eye_at", "eye_importance", "picture_point"])
        .prelude(device::Camera::glsl())
        .glsl(&format!(
            "{GLSL} vec3 p = in_vec3(); EyeSample s = eye_sample(camera, p); {WRITE}
             out_f(eye_importance(camera, p));"
        ))
        .rust(|i, o| {
            let (camera, p) = (read_camera(i), i.vec3());
            write(eye_sample(&camera, p), o);
            o.f(eye_importance(&camera, p));
        })
        // At the eye, before it, behind it, on edges of the picture.
        .edge(point(Vec3::zero()))
        .edge(point(FORWARD))
        .edge(point(-FORWARD))
        .edge(point(FORWARD + RIGHT))
        .edge(point(FORWARD - UP))
        .seeded(4000, move |r| point(seen(r)))
}

fn direction() -> Twin {
    let pixel =
        |size: [u32; 2], at: [u32; 2], ab: [f32; 2]| camera(size).u(at[0]).u(at[1]).vec2(ab);
    let last = 1.0 - 2f32.powi(-24);
    Twin::new("camera_direction", "camera/pinhole")
        .prelude(device::Camera::glsl())
        .glsl(&format!(
            "{GLSL} uint x = in_u(); uint y = in_u(); float a = in_f();
             out_vec3(camera_direction(camera, x, y, a, in_f()));"
        ))
        .rust(|i, o| {
            let camera = read_camera(i);
            o.vec3(camera_direction(&camera, i.u(), i.u(), i.f(), i.f()));
        })
        .edge(pixel([1, 1], [0, 0], [0.5, 0.5]))
        .edge(pixel([640, 480], [0, 479], [0.0, 0.0]))
        .edge(pixel([640, 480], [639, 0], [last, last]))
        .edge(pixel([8192, 8191], [8191, 8190], [last, 0.0]))
        .seeded(5000, move |r| {
            let size = if r.bool() { [640, 480] } else { [8192, 8191] };
            let at = [r.below(size[0]), r.below(size[1])];
            pixel(size, at, [r.unit(), r.unit()])
        })
}

fn disc() -> Twin {
    let last = 1.0 - 2f32.powi(-24);
    // The middle, corners, edges, diagonals, and next to the middle.
    let edges = [0.0, 0.5, last, 0.5 + 2f32.powi(-24), 0.25, 0.75];
    let edges = edges.map(|x| edges.map(|y| Row::new().vec2([x, y])));
    Twin::new("disc_point", "camera/lens")
        .prelude(device::Camera::glsl() + &device::Lens::glsl())
        .glsl("out_vec2(disc_point(in_vec2()));")
        .rust(|i, o| o.vec2(disc_point(i.vec2())))
        .edges(edges.into_iter().flatten())
        .seeded(5000, |r| Row::new().vec2([r.unit(), r.unit()]))
}

fn lens() -> Twin {
    let row = |lens: [f32; 3], q: [f32; 2], p: Vec3<f32>| {
        let row = camera([640, 480]).f(lens[0]).f(lens[1]).f(lens[2]);
        row.vec2(q).vec3(p)
    };
    Twin::new("lens_sample", "camera/lens")
        .also(&["lens_point", "lens_pixel"])
        .prelude(device::Camera::glsl() + &device::Lens::glsl())
        .glsl(&format!(
            "{GLSL} {LENS} vec2 q = in_vec2(); EyeSample s = lens_sample(camera, lens, q, in_vec3()); {WRITE}
             out_vec3(lens_point(camera, lens, q));
             out_vec2(lens_pixel(lens, q, vec2(0.25, 0.75)));"
        ))
        .rust(|i, o| {
            let camera = read_camera(i);
            let lens = read_lens(&camera, i);
            let (q, p) = (i.vec2(), i.vec3());
            write(lens_sample(&camera, &lens, q, p), o);
            o.vec3(lens_point(&camera, &lens, q));
            o.vec2(lens_pixel(&lens, q, [0.25, 0.75]));
        })
        // A pinhole; the lens's middle, its edge, a point on it; one behind it.
        .edge(row([0.0; 3], [0.3, -0.4], FORWARD))
        .edge(row([0.1, 0.1, 9.0], [0.0; 2], FORWARD + RIGHT))
        .edge(row([0.1, 0.1, 9.0], [-1.0, 0.0], FORWARD))
        .edge(row([1.0, 1.0, 9.0], [1.0, 0.0], RIGHT))
        .edge(row([0.1, 0.1, 9.0], [0.5, 0.5], -FORWARD))
        .seeded(4000, move |r| {
            let size = r.log_range(1e-4, 1e4);
            let q = disc_point([r.unit(), r.unit()]);
            row([size, size, r.log_range(1e-3, 1e3)], q, seen(r))
        })
}
