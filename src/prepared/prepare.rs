//! Scene → [`Prepared`].

use glam::{DQuat, DVec3};

use super::cdf::CdfError;
use super::dark;
use super::light_tree::LightTree;
use super::lights::{Lights, Outside};
use super::medium::Media;
use super::placed::Placed;
use super::{
    Camera, Light, LightKind, Material, MaterialKind, NONE, Prepared, Space, Surroundings,
    coincide, eye, lens, material, medium, range,
};
use crate::scene::{self, MaterialKind as SceneMaterial, Scene};
use crate::settings::Settings;

/// A scene beyond the limits of the kernels' tables or of single precision.
#[derive(Debug, thiserror::Error)]
pub enum PrepareError {
    #[error("cannot choose among the lights of this scene: {0}")]
    Lights(#[from] CdfError),
    #[error(
        "line {line}: the index of refraction {ior:e} or its inverse has no square in single precision"
    )]
    Ior { line: usize, ior: f64 },
    #[error("line {line}: the camera exceeds single precision: its field of view is too wide")]
    Camera { line: usize },
    #[error(
        "line {line}: the lens exceeds single precision: it is too wide, or too wide for its focal distance"
    )]
    Lens { line: usize },
}

/// Everything that both renderers share, for a picture of `size` (by default the scene's own).
///
/// # Errors
/// The scene exceeds the kernels' integer tables (more than 2²⁴ lights, or triangles in one light), or a derived value
/// is infinite in single precision although each number of the scene file is finite there.
pub fn prepare(
    scene: &Scene,
    settings: &Settings,
    size: Option<[u32; 2]>,
) -> Result<Prepared, PrepareError> {
    let [width, height] = size.unwrap_or([scene.screen.width, scene.screen.height]);
    let mut materials: Vec<Material> = scene
        .materials
        .iter()
        .map(|m| match &m.kind {
            SceneMaterial::Brdf(brdf) => Material {
                words: m.words,
                ..material::material(brdf, &settings.model, m.line)
            },
            SceneMaterial::Light(radiance) => material::light(*radiance, m.line),
        })
        .collect();
    let mut warnings = Vec::new();
    let mut placed = Placed::new(scene, &materials, &mut warnings);
    let space = Space::of(
        placed.all_bounds(scene.camera.eye),
        lens::bounds(scene.camera.eye, scene.lens),
    );
    placed.move_to(&space);
    materials
        .iter_mut()
        .for_each(|m| m.sigma = material::extinction_in(m.sigma, &space));
    let surroundings = match &scene.surroundings {
        Some(surroundings) => Surroundings::new(surroundings)?,
        None => None,
    };
    let outside = outside(scene, surroundings.as_ref());
    let lights = Lights::new(&placed, &materials, outside)?;
    let camera = camera(&scene.camera, &space, width, height);
    range::check_camera(&camera, scene.camera_line)?;
    let lens = lens::lens(scene.lens, &camera, &space)?;
    range::check_materials(&materials)?;
    range::warn_of_narrow(&camera, scene.camera_line, &mut warnings);
    range::warn_of_small(&placed, &space, &mut warnings);
    range::enlarge(&mut placed);
    let largest = (surroundings.as_ref()).map_or(scene.background.max_element(), |s| s.largest);
    range::warn_of_radiances(&materials, (largest, scene.background_line), &mut warnings);
    medium::warn_of_overlaps(&placed, &materials, &mut warnings);
    placed.primitives.coincident = coincide::coincidences(&placed, &materials);
    eye::warn_of_surface(camera.eye, &placed, &materials, &mut warnings);
    if let Some(lens) = &lens {
        lens::warn_of_wide(&camera, lens, &mut warnings);
        lens::warn_of_crossing(camera.eye, lens, &placed, &mut warnings);
    }
    dark::warn_of_no_light(&lights.lights, &mut warnings);
    dark::warn_of_shut_in(
        camera.eye,
        &placed,
        &materials,
        &lights.lights,
        &mut warnings,
    );
    let (eye_medium, light_media) = media(camera.eye, &placed, &materials, &lights.lights);
    let aims = super::aims::aims(&placed, &materials);
    let light_share = super::aims::light_share(&placed, &lights.lights, &aims);
    let light_tree = LightTree::new(&placed, &lights.lights, outside.mean);
    let mut shapes = placed.shapes;
    for (i, light) in lights.lights.iter().enumerate() {
        if light.shape != NONE {
            shapes[light.shape as usize].light = i as u32;
        }
    }
    Ok(Prepared {
        space,
        camera,
        lens,
        shapes,
        primitives: placed.primitives,
        materials,
        lights: lights.lights,
        light_cdf: lights.light_cdf,
        light_tree,
        light_media,
        aims,
        light_share,
        triangle_cdf: lights.triangle_cdf,
        background: outside.mean,
        surroundings,
        background_line: scene.background_line,
        eye_medium,
        warnings,
    })
}

/// Everything outside as a light.
fn outside(scene: &Scene, surroundings: Option<&Surroundings>) -> Outside {
    match surroundings {
        Some(s) => Outside {
            kind: LightKind::Surroundings,
            radiance: DVec3::splat(s.scale),
            mean: s.mean,
        },
        None => Outside {
            kind: LightKind::Background,
            radiance: scene.background,
            mean: scene.background,
        },
    }
}

/// The scene's camera looks down −Z of its frame. `ry` is the tangent of half the vertical field of view, rx = ry·W/H.
fn camera(camera: &scene::Camera, space: &Space, width: u32, height: u32) -> Camera {
    let rotate = |q: DQuat, v: DVec3| (q * v).normalize();
    let rx = camera.ry * f64::from(width) / f64::from(height);
    Camera {
        eye: space.point(camera.eye),
        width,
        height,
        right: rotate(camera.orientation, DVec3::X) * rx,
        up: rotate(camera.orientation, DVec3::Y) * camera.ry,
        forward: rotate(camera.orientation, DVec3::NEG_Z),
    }
}

impl Prepared {
    /// Whether light passes through the inside of shapes with this material.
    pub fn is_transmissive(material: &Material) -> bool {
        matches!(
            material.kind,
            MaterialKind::RoughDielectric
                | MaterialKind::SmoothDielectric
                | MaterialKind::WeakDielectric
                | MaterialKind::NullInterface
        )
    }
}

/// The material of the shape that contains the eye, and for each light the material around its centre, or [`NONE`].
fn media(eye: DVec3, placed: &Placed, materials: &[Material], lights: &[Light]) -> (u32, Vec<u32>) {
    let media = Media::new(placed, materials);
    let of_light = |light: &Light| match placed.shapes.get(light.shape as usize) {
        Some(shape) => media.at(placed.body(shape).bounds().centre()),
        None => NONE,
    };
    (media.at(eye), lights.iter().map(of_light).collect())
}
