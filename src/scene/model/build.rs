//! A scene under construction, and its messages.

use std::path::Path;

use glam::DVec3;

use super::ball::{Ball, around};
use super::document::Document;
use super::lamps::{self, Lamp};
use super::left_out::LeftOut;
use super::listing::{Listing, number, numbers};
use super::materials::{self, Materials};
use super::view::{self, View};
use super::{shapes, unread};
use crate::scene::log::Log;
use crate::scene::mesh::gltf::Whole;
use crate::scene::{Errors, Read, Scene};

/// A scene under construction.
pub(super) struct Build<'a> {
    path: &'a Path,
    log: Log,
    left_out: LeftOut,
    listing: Listing,
}

impl<'a> Build<'a> {
    pub(super) fn new(log: Log, path: &'a Path, bytes: &[u8]) -> Self {
        let mut listing = Listing::default();
        // The hash distinguishes files with the same listing.
        let hash = blake3::hash(bytes).to_hex();
        listing.add("# glTF, as vkpt reads it; BLAKE3 of the file:", "");
        listing.add(&format!("# {hash}"), "");
        Self {
            path,
            log,
            left_out: LeftOut::default(),
            listing,
        }
    }

    /// The scene; `None` if an error was logged.
    pub(super) fn scene(
        &mut self,
        document: &Document,
        whole: &Whole,
        camera: Option<&str>,
    ) -> Option<Scene> {
        let warnings = whole.mesh.warnings.iter();
        warnings.for_each(|what| self.warn(what));
        let ball = around(&whole.mesh);
        let view = self.view(document, whole, camera, &ball);
        unread::note(document, &mut self.left_out);
        let mut materials = Materials::read(document, &whole.parts, &mut self.left_out);
        materials.errors.iter().for_each(|what| self.fail(what));
        let lamps = self.lamps(document, whole, &ball);
        let (view, lamps) = (view?, lamps?);
        if !materials.errors.is_empty() {
            return None;
        }
        let camera_line = self.list_view(&view);
        let shines = materials.shine() || !lamps.is_empty();
        let (background, background_line) = self.background(shines);
        self.list_materials(&mut materials);
        let listing = &mut self.listing;
        let mut shapes = shapes::meshes(whole, self.path, &materials, listing);
        materials.note_both_sides(document, &shapes, &mut self.left_out);
        shapes::add_lamps(document, lamps, &mut materials, listing, &mut shapes);
        Some(Scene {
            path: self.path.to_owned(),
            screen: view.screen,
            camera: view.camera,
            camera_line,
            lens: None,
            background,
            surroundings: None,
            background_line,
            materials: materials.into_all(),
            shapes,
        })
    }

    /// The view of a camera, or a view of the whole scene.
    fn view(
        &mut self,
        document: &Document,
        whole: &Whole,
        camera: Option<&str>,
        ball: &Ball,
    ) -> Option<View> {
        match view::of_camera(document, &whole.nodes, camera) {
            Ok(Some(view)) => Some(view),
            Ok(None) => {
                let view = view::of_all(ball.centre, ball.radius);
                match view {
                    Some(_) => self.note("it has no camera: the view is from the front, right and above, and shows everything"),
                    None => self.fail("it has no camera, and is too large for a default view in single precision: add a camera"),
                }
                view
            }
            Err(what) => {
                self.fail(&what);
                None
            }
        }
    }

    /// The balls that replace point lights.
    fn lamps(&mut self, document: &Document, whole: &Whole, ball: &Ball) -> Option<Vec<Lamp>> {
        let radius = ball.lamp_radius();
        let lamps = lamps::lamps(document, &whole.nodes, radius, &mut self.left_out);
        if lamps.as_ref().is_ok_and(|lamps| !lamps.is_empty()) {
            self.note(&format!(
                "its point lights are balls of radius {radius:.2e} of the same power"
            ));
        }
        lamps.map_err(|what| self.fail(&what)).ok()
    }

    /// Lists screen and camera; returns the camera's line.
    fn list_view(&mut self, view: &View) -> usize {
        let View { camera, screen, of } = view;
        let line = format!("screen {} {}", screen.width, screen.height);
        self.listing.add(&line, "");
        let q = camera.orientation;
        let q = [q.w, q.x, q.y, q.z].map(number).join(" ");
        let line = format!(
            "camera {}  {}  q {q}",
            numbers(camera.eye),
            number(camera.ry)
        );
        self.listing.add(&line, of)
    }

    /// The background and its line; white if nothing emits light.
    fn background(&mut self, shines: bool) -> (DVec3, usize) {
        if shines {
            return (DVec3::ZERO, 0);
        }
        self.note("it has no lights: the background is white, with radiance 1");
        let line = self
            .listing
            .add("background 1 1 1", "the file has no lights");
        (DVec3::ONE, line)
    }

    fn list_materials(&mut self, materials: &mut Materials) {
        for (material, label) in materials.all_mut() {
            material.line = self.listing.add(&materials::listed(&material.kind), label);
        }
    }

    /// The scene with its messages, if there are no errors; with `strict`, warnings count as errors.
    pub(super) fn finish(mut self, scene: Option<Scene>, strict: bool) -> Result<Read, Errors> {
        let left_out: Vec<String> = self.left_out.sentences().collect();
        left_out.iter().for_each(|what| self.warn(what));
        let (scene, warnings) = self.log.finish(scene, strict)?;
        Ok(Read {
            scene,
            warnings,
            text: self.listing.into_text(),
            is_listing: true,
        })
    }

    fn fail(&mut self, what: &str) {
        self.log
            .file_error(format!("{}: {what}", self.path.display()));
    }

    fn warn(&mut self, what: &str) {
        self.log
            .file_warning(format!("{}: {what}", self.path.display()));
    }

    fn note(&mut self, what: &str) {
        self.log
            .file_note(format!("{}: {what}", self.path.display()));
    }
}
