//! Shapes: `sphere`, `box`, `cylinder`, `mesh`.

use super::arguments::Arguments;
use super::builder::Builder;
use super::field::{any, not_zero, positive, vector};
use super::file_path::{FilePath, file_path, similar};
use super::mesh::{MeshError, is_mesh_name, read_mesh};
use super::orientation::orientation;
use super::{Geometry, Mesh};

/// `sphere cx cy cz  r`
pub(super) fn sphere(builder: &mut Builder, arguments: &mut Arguments) {
    let fields = [any("cx"), any("cy"), any("cz"), positive("r", "the radius")];
    let Some([centre @ .., r]) = arguments.numbers(&mut builder.log, fields) else {
        return;
    };
    let geometry = Geometry::Sphere {
        centre: vector(&centre),
        radius: r.value,
    };
    builder.add_shape(arguments.command().place.line, geometry);
}

/// `box bx by bz  dx dy dz`
pub(super) fn cuboid(builder: &mut Builder, arguments: &mut Arguments) {
    let side = |name| not_zero(name, "a side of the box");
    let fields = [
        any("bx"),
        any("by"),
        any("bz"),
        side("dx"),
        side("dy"),
        side("dz"),
    ];
    let Some([corner @ .., dx, dy, dz]) = arguments.numbers(&mut builder.log, fields) else {
        return;
    };
    let geometry = Geometry::Box {
        corner: vector(&corner),
        diagonal: vector(&[dx, dy, dz]),
    };
    builder.add_shape(arguments.command().place.line, geometry);
}

/// `cylinder bx by bz  ax ay az  r`
pub(super) fn cylinder(builder: &mut Builder, arguments: &mut Arguments) {
    let log = &mut builder.log;
    let [bx, by, bz, ax, ay, az] = ["bx", "by", "bz", "ax", "ay", "az"].map(any);
    let fields = [bx, by, bz, ax, ay, az, positive("r", "the radius")];
    let Some([bx, by, bz, ax, ay, az, r]) = arguments.numbers(log, fields) else {
        return;
    };
    let axis = vector(&[ax, ay, az]);
    if axis.length() as f32 == 0.0 {
        let place = ax.place.to(az.place);
        log.error(
            place,
            "the axis of the cylinder must not be zero".into(),
            "its length is the cylinder's height",
        );
        return;
    }
    let geometry = Geometry::Cylinder {
        base: vector(&[bx, by, bz]),
        axis,
        radius: r.value,
    };
    builder.add_shape(arguments.command().place.line, geometry);
}

/// `mesh FILE  tx ty tz  s  ORIENTATION`
pub(super) fn mesh(builder: &mut Builder, arguments: &mut Arguments) {
    let folder = builder.folder().to_owned();
    let named = file_path(&folder, arguments, &mut builder.log, is_mesh_name);
    let Some(FilePath { path, place }) = named else {
        return;
    };
    let read = read_mesh(&path);
    let log = &mut builder.log;
    match &read {
        Err(reason) => {
            log.lacks_memory |= matches!(reason, MeshError::Memory(_));
            let error = log.error(place, format!("{}: {reason}", path.display()), "");
            if matches!(reason, MeshError::Missing) {
                let is_utf_8 = !path.to_string_lossy().contains(char::REPLACEMENT_CHARACTER);
                error.help(
                    match similar(&folder, &path, is_mesh_name).filter(|_| is_utf_8) {
                        Some(name) => format!("did you mean `{name}`?"),
                        None if is_utf_8 => LOOKED_FOR.to_owned(),
                        None => {
                            "the name is not UTF-8: save the scene as UTF-8, or rename the mesh"
                                .to_owned()
                        }
                    },
                );
            }
        }
        Ok(mesh) => {
            for warning in &mesh.warnings {
                log.warning(place, format!("{}: {warning}", path.display()), "");
            }
        }
    }
    let fields = [any("tx"), any("ty"), any("tz"), positive("s", "the scale")];
    let numbers = arguments.numbers(log, fields);
    let rotate = orientation(arguments, log);
    if let (Ok(file), Some([tx, ty, tz, s]), Some(rotate)) = (read, numbers, rotate) {
        let mesh = Mesh {
            path,
            files: file.files,
            positions: file.positions,
            normals: file.normals,
            triangles: file.triangles,
            translate: vector(&[tx, ty, tz]),
            scale: s.value,
            rotate,
        };
        builder.add_shape(arguments.command().place.line, Geometry::Mesh(mesh));
    }
}

const LOOKED_FOR: &str = "a mesh is searched next to the scene file, then in the working directory";
