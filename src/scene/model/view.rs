//! The camera and view of a scene (docs/gltf.md, "Cameras").

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::document::{Document, Perspective};
use super::legal::positive;
use crate::scene::mesh::gltf::{Placed, called};
use crate::scene::text::quote;
use crate::scene::{Camera, LARGEST_SIDE, Screen};

/// Width of the picture if no size is given.
const WIDTH: u32 = 400;

/// A view of a scene.
pub(super) struct View {
    pub(super) camera: Camera,
    pub(super) screen: Screen,
    /// Its origin, for the listing.
    pub(super) of: String,
}

/// A camera at a node.
struct Seen<'a> {
    node: &'a Placed,
    number: usize,
    names: [Option<&'a str>; 2],
}

/// The view of the camera named `name`, by default the first; `None` if there is no camera and no name. Errors are
/// messages.
pub(super) fn of_camera(
    document: &Document,
    nodes: &[Placed],
    name: Option<&str>,
) -> Result<Option<View>, String> {
    let cameras = cameras(document, nodes)?;
    let found = match name {
        None => cameras.first(),
        Some(name) => {
            let by_name = |place: usize| cameras.iter().find(move |c| c.names[place] == Some(name));
            let by_number = || cameras.iter().find(|c| c.number.to_string() == name);
            let found = by_name(0).or_else(|| by_name(1)).or_else(by_number);
            Some(found.ok_or_else(|| unknown(name, &cameras))?)
        }
    };
    found.map(|seen| view(document, seen)).transpose()
}

/// The cameras of a scene in the order of its nodes.
fn cameras<'a>(document: &'a Document, nodes: &'a [Placed]) -> Result<Vec<Seen<'a>>, String> {
    let mut cameras = Vec::new();
    for node in nodes {
        let own = document.nodes.get(node.number);
        let Some((own, number)) = own.and_then(|own| Some((own, own.camera?))) else {
            continue;
        };
        let camera = document.cameras.get(number);
        let camera =
            camera.ok_or_else(|| format!("{}: camera {number} does not exist", node.label))?;
        cameras.push(Seen {
            node,
            number,
            names: [own.name.as_deref(), camera.name.as_deref()],
        });
    }
    Ok(cameras)
}

/// A message that lists the available cameras.
fn unknown(name: &str, cameras: &[Seen]) -> String {
    let name = quote(name);
    let names: Vec<String> = cameras
        .iter()
        .map(|c| match c.names.iter().flatten().next() {
            Some(name) => format!("`{}`", quote(name)),
            None => format!("`{}`", c.number),
        })
        .collect();
    match &names[..] {
        [] => format!("camera `{name}` does not exist: its scene has no cameras"),
        names => format!(
            "camera `{name}` does not exist; its cameras are {}",
            names.join(", ")
        ),
    }
}

fn view(document: &Document, seen: &Seen) -> Result<View, String> {
    let camera = &document.cameras[seen.number];
    let label = called("camera", seen.number, camera.name.as_deref());
    let within = |what: String| format!("{label}: {what}");
    let lens = camera.perspective.as_ref().ok_or_else(|| {
        within(
            "it is not perspective: use a perspective camera, or choose one with --camera".into(),
        )
    })?;
    let to_scene = seen.node.to_scene.clone()?;
    let orientation = orientation(&to_scene).ok_or_else(|| {
        within(format!(
            "the scale of {} leaves it no direction",
            seen.node.label
        ))
    })?;
    let eye = to_scene.translation;
    if !eye.as_vec3().is_finite() {
        return Err(within(
            "its position is not finite in single precision".into(),
        ));
    }
    Ok(View {
        camera: Camera {
            eye,
            ry: ry(lens).map_err(within)?,
            orientation,
        },
        screen: screen(lens).map_err(within)?,
        of: format!("{label} at {}", seen.node.label),
    })
}

/// ry = tan(yfov/2)
fn ry(lens: &Perspective) -> Result<f64, String> {
    let yfov = positive("yfov", lens.yfov)?;
    let ry = (yfov / 2.0).tan();
    match yfov < std::f64::consts::PI && (ry as f32).is_finite() {
        true if ry as f32 > 0.0 => Ok(ry),
        true => Err("its yfov is too small for single precision".to_owned()),
        false => Err("its yfov must be below π".to_owned()),
    }
}

/// 400 pixels wide; the aspect ratio, by default 4:3, gives the height.
fn screen(lens: &Perspective) -> Result<Screen, String> {
    let aspect = positive("aspectRatio", lens.aspect_ratio.unwrap_or(4.0 / 3.0))?;
    let height = (f64::from(WIDTH) / aspect).round();
    Ok(Screen {
        width: WIDTH,
        height: height.clamp(1.0, f64::from(LARGEST_SIDE)) as u32,
    })
}

/// The rotation of a camera's transform without its scale: Z is kept, Y is made perpendicular to it.
fn orientation(to_scene: &DAffine3) -> Option<DQuat> {
    let m = to_scene.matrix3;
    let z = m.z_axis.try_normalize()?;
    let x = m.y_axis.try_normalize()?.cross(z).try_normalize()?;
    let rotation = DQuat::from_mat3(&DMat3::from_cols(x, z.cross(x), z)).normalize();
    rotation.is_finite().then_some(rotation)
}

/// tan of half of 40°
const RY: f64 = 0.363_970_234_266_202_36;

/// A view of a whole ball, from the front (+Z), its right and above. `None`: the ball is too large.
pub(super) fn of_all(centre: DVec3, radius: f64) -> Option<View> {
    // 30° to the right of +Z, 20° up.
    let rotation =
        DQuat::from_rotation_y(30f64.to_radians()) * DQuat::from_rotation_x(-20f64.to_radians());
    // From a distance r/sin θ a ball of radius r spans the half-angle θ; a tenth farther, less.
    let sin = RY / RY.hypot(1.0);
    let distance = if radius > 0.0 {
        1.1 * radius / sin
    } else {
        1.0
    };
    let eye = centre + distance * (rotation * DVec3::Z);
    let camera = Camera {
        eye,
        ry: RY,
        orientation: rotation.normalize(),
    };
    let screen = Screen {
        width: WIDTH,
        height: WIDTH * 3 / 4,
    };
    let of = "shows everything: the file has no camera".to_owned();
    eye.as_vec3()
        .is_finite()
        .then_some(View { camera, screen, of })
}
