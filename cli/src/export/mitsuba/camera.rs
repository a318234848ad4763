//! The camera, its film and its samples.

use glam::DMat4;

use super::document::Node;
use super::surface::medium_id;
use crate::export::Subject;
use crate::export::seen::absorbs;

/// Mitsuba clips everything nearer than one plane or farther than another. In units of rendering space, where no shape
/// is farther than 4 from the eye: in single precision anything before the near plane is indistinguishable from the
/// eye.
const NEAR: f64 = 1.0 / 65536.0;
const FAR: f64 = 1024.0;

/// The sensor. Uniform points in a pixel with equal weights are vkpt's box filter.
pub fn node(subject: &Subject) -> Node {
    let Subject {
        scene, prepared, ..
    } = subject;
    let camera = &scene.camera;
    // `None` if the eye is in air.
    let (unit, medium) = (prepared.space.unit, prepared.eye_medium);
    let lens = scene.lens.filter(|lens| lens.radius > 0.0);
    let kind = match lens {
        Some(_) => "thinlens",
        None => "perspective",
    };
    let sensor = Node::plugin("sensor", kind)
        .string("fov_axis", "y")
        .float("fov", 2.0 * camera.ry.atan().to_degrees())
        .float("near_clip", NEAR * unit)
        .float("far_clip", FAR * unit)
        // Mitsuba's camera looks along +Z with X to its left, vkpt's along −Z with X to its right.
        .placed(
            DMat4::from_rotation_translation(camera.orientation, camera.eye)
                * DMat4::from_scale((-1.0, 1.0, -1.0).into()),
        )
        .with(film(subject))
        .with(Node::plugin("sampler", "independent").integer("sample_count", SAMPLES));
    let sensor = match lens {
        // Both planes are perpendicular to the direction of view.
        Some(lens) => {
            (sensor.float("aperture_radius", lens.radius)).float("focus_distance", lens.focus)
        }
        None => sensor,
    };
    match prepared.materials.get(medium as usize) {
        Some(glass) if absorbs(glass) => sensor.named_reference("medium", &medium_id(glass)),
        _ => sensor,
    }
}

/// vkpt's default number of samples.
const SAMPLES: i64 = 64;

fn film(subject: &Subject) -> Node {
    let camera = &subject.prepared.camera;
    let film = Node::plugin("film", "hdrfilm")
        .integer("width", camera.width)
        .integer("height", camera.height)
        .string("pixel_format", "rgb")
        .string("component_format", "float32")
        .with(Node::plugin("rfilter", "box"));
    match subject.crop {
        None => film,
        Some([x0, y0, x1, y1]) => film
            .integer("crop_offset_x", x0)
            .integer("crop_offset_y", y0)
            .integer("crop_width", x1 - x0)
            .integer("crop_height", y1 - y0),
    }
}
