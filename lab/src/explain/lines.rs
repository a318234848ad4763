//! The lines of a scene that need a member.

use glam::DVec3;

use vkpt::features::{Member, is_rough, is_specular};
use vkpt::prepared::{Light, Material, Prepared, Shape, ShapeKind};

/// The lines in ascending order, each once; 0 is the default material of shapes that follow none.
pub fn lines(prepared: &Prepared, member: Member) -> Vec<usize> {
    let shapes = |of: &dyn Fn(&Shape) -> bool| -> Vec<usize> {
        let shapes = prepared.shapes.iter().filter(|s| of(s));
        shapes.map(|s| s.line).collect()
    };
    let mut lines = match member {
        Member::Shape(kind) | Member::InBvh(kind) => shapes(&|s| s.kind == kind),
        Member::Light(kind) => lights(prepared, |l| l.kind == kind),
        Member::LightPick(pick) if pick.picks_among(prepared.lights.len()) => {
            lights(prepared, |_| true)
        }
        Member::LightPick(_) => Vec::new(),
        Member::Lens => prepared.lens.iter().map(|l| l.line).collect(),
        Member::ShadingNormals => shapes(&|s| has_normals(prepared, s)),
        Member::Covered(kind) => covered(prepared, kind),
        _ => materials(prepared, member).map(|m| m.line).collect(),
    };
    lines.sort_unstable();
    lines.dedup();
    lines
}

/// The materials of shapes that need a member, in the order of their lines.
pub fn materials(prepared: &Prepared, member: Member) -> impl Iterator<Item = &Material> {
    let mut used: Vec<&Material> = prepared
        .shapes
        .iter()
        .map(|s| &prepared.materials[s.material as usize])
        .filter(|m| brings(m, member))
        .collect();
    used.sort_by_key(|m| m.line);
    used.dedup_by_key(|m| m.line);
    used.into_iter()
}

fn brings(m: &Material, member: Member) -> bool {
    match member {
        Member::Material(kind) => m.kind == kind,
        Member::DiffuseBeside => is_specular(m.kind) && m.kd_mean > 0.0,
        Member::Distribution(distribution) => is_rough(m.kind) && m.distribution == distribution,
        Member::Fresnel(form) => is_specular(m.kind) && m.fresnel == form,
        Member::Aims => m.gathers(),
        Member::Absorption(_) => Prepared::is_transmissive(m) && m.sigma != DVec3::ZERO,
        _ => false,
    }
}

fn lights(prepared: &Prepared, of: impl Fn(&Light) -> bool) -> Vec<usize> {
    let line = |l: &Light| match (l.kind, l.shape) {
        (kind, _) if kind.is_outside() => prepared.background_line,
        (_, shape) => prepared.shapes[shape as usize].line,
    };
    prepared.lights.iter().filter(|l| of(l)).map(line).collect()
}

/// The lines of shapes of a kind with a face that may be covered, and of those that cover it.
fn covered(prepared: &Prepared, kind: ShapeKind) -> Vec<usize> {
    let table = &prepared.primitives.coincident;
    let of_kind = (0..).zip(&prepared.shapes).filter(|(_, s)| s.kind == kind);
    let lists = of_kind.flat_map(|(i, shape)| {
        let lists = shape.faces().map(move |prim| (i, table.of(i, prim)));
        lists.filter(|(_, list)| !list.is_empty())
    });
    let shapes = lists.flat_map(|(i, list)| list.iter().map(|c| c.shape).chain([i]));
    shapes.map(|i| prepared.shapes[i as usize].line).collect()
}

/// Whether the mesh file has a normal for any corner.
fn has_normals(prepared: &Prepared, shape: &Shape) -> bool {
    let (first, count) = (shape.first as usize, shape.count as usize);
    let own = prepared.primitives.normals.get(first..first + count);
    shape.kind == ShapeKind::Mesh
        && own.is_some_and(|own| own.iter().flatten().any(|n| *n != DVec3::ZERO))
}
