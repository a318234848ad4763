//! Twins of `shaders/camera/`.

use vkpt::layout::GpuStruct;
use vkpt::prepared::device;
use vkpt::reference::camera::{Camera, camera_direction, eye_sample};
use vkpt::reference::math::{Vec3, vec3};

use super::harness::{In, Row, Twin};

/// A 640 × 480 or an 8192 × 8191 picture, seen by a camera that is turned.
const GLSL: &str = "
    Camera camera;
    camera.right = in_vec3();
    camera.up = in_vec3();
    camera.forward = in_vec3();
    camera.width = in_u();
    camera.height = in_u();";

fn read_camera(i: &mut In) -> Camera<f32> {
    Camera {
        eye: Vec3::zero(),
        right: i.vec3(),
        up: i.vec3(),
        forward: i.vec3(),
        width: i.u(),
        height: i.u(),
    }
}

pub fn twins() -> Vec<Twin> {
    let right = vec3(0.264, -0.07, 0.01);
    let (up, forward) = (vec3(-0.33, -0.189, 0.925), vec3(-0.803, -0.458, -0.381));
    let pixel = move |size: [u32; 2], at: [u32; 2], ab: [f32; 2]| {
        let axes = Row::new().vec3(right).vec3(up).vec3(forward);
        axes.u(size[0]).u(size[1]).u(at[0]).u(at[1]).vec2(ab)
    };
    let last = 1.0 - 2f32.powi(-24);
    // A point of the picture, or somewhere: seen, beside the picture, behind the eye, at it.
    let point = move |at: Vec3<f32>| pixel([640, 480], [0, 0], [0.0; 2]).vec3(at);
    vec![
        Twin::new("eye_sample", "camera/eye")
            .prelude(device::Camera::glsl())
            .glsl(&format!(
                "{GLSL} uint x = in_u(); uint y = in_u(); vec2 ab = in_vec2(); camera.eye = vec3(0.0);
                 EyeSample s = eye_sample(camera, in_vec3());
                 out_vec3(s.wi); out_f(s.distance); out_b(s.seen); out_u(s.column); out_u(s.row); out_f(s.importance);"
            ))
            .rust(|i, o| {
                let camera = read_camera(i);
                let _ = (i.u(), i.u(), i.vec2());
                let s = eye_sample(&camera, i.vec3());
                o.vec3(s.wi);
                o.f(s.distance);
                o.b(s.seen);
                o.u(s.column);
                o.u(s.row);
                o.f(s.importance);
            })
            .edge(point(Vec3::zero()))
            .edge(point(forward))
            .edge(point(-forward))
            .edge(point(forward + right))
            .edge(point(forward - up))
            .seeded(4000, move |r| {
                let aside = right * r.range(-1.2, 1.2) + up * r.range(-1.2, 1.2);
                point((forward + aside) * r.log_range(1e-6, 1e6))
            }),
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
            }),
    ]
}
