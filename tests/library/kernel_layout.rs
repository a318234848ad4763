//! The structs that host and kernel share, against the offsets that naga gives them.

use vkpt::kernel::{Composer, Member, StructLayout, struct_layouts};
use vkpt::layout::{
    Field, FilmMoments, FilmPixel, GpuStruct, PathOutcome, PathState, Ray, Record, ShadowRay,
    Slice, Subpath,
};
use vkpt::prepared::device::{Camera, Cuboid, Cylinder, Light, Material, Shape, Sphere};

/// Name, size and member offsets, as Rust has them.
fn ours<T: GpuStruct>() -> StructLayout {
    let member = |f: &Field| Member {
        name: f.name.into(),
        offset: f.offset as u32,
    };
    let members = T::FIELDS.iter().map(member).collect();
    StructLayout {
        name: T::NAME.into(),
        size: size_of::<T>() as u32,
        members,
    }
}

/// Structs within other structs, in the order in which GLSL wants them.
const NESTED: [&str; 3] = [Ray::NAME, ShadowRay::NAME, Subpath::NAME];

/// The same, as naga has them in a uniform buffer (std140) and in a storage buffer (std430).
fn nagas<T: GpuStruct>(glsl: &str) -> [StructLayout; 2] {
    // Any scalar will do: naga omits what a kernel does not use.
    let first = T::FIELDS[0];
    let component = match first.ty {
        "Ray" => ".t_max",
        "Subpath" => ".pdf",
        ty if ty.contains("vec") => ".x",
        _ => "",
    };
    ["std140) uniform", "std430) readonly buffer"].map(|kind| {
        let text = format!(
            "{ray}{shadow}{subpath}{rest}
layout(set = 0, binding = 0, {kind} Items {{ {name} items[4]; }} source;
layout(set = 0, binding = 1, std430) buffer Out {{ float x; }} result;
void main() {{ result.x = float(source.items[1].{field}{component}); }}\n",
            ray = Ray::glsl(),
            shadow = ShadowRay::glsl(),
            subpath = Subpath::glsl(),
            rest = if NESTED.contains(&T::NAME) { "" } else { glsl },
            name = T::NAME,
            field = first.name,
        );
        let kernel = Composer::new()
            .add("root", text)
            .compose(&["root"])
            .expect("composes");
        let layouts = struct_layouts(&kernel).expect("compiles");
        layouts
            .into_iter()
            .find(|l| l.name == T::NAME)
            .expect("the struct is used")
    })
}

#[test]
fn naga_lays_out_every_struct_as_rust_does() {
    fn check<T: GpuStruct>() {
        for theirs in nagas::<T>(&T::glsl()) {
            assert_eq!(theirs, ours::<T>());
        }
    }
    check::<Material>();
    check::<Sphere>();
    check::<Cuboid>();
    check::<Cylinder>();
    check::<Shape>();
    check::<Light>();
    check::<Camera>();
    check::<Ray>();
    check::<ShadowRay>();
    check::<Subpath>();
    check::<PathState>();
    check::<FilmPixel>();
    check::<FilmMoments>();
    check::<Record>();
    check::<PathOutcome>();
    check::<Slice>();
}

/// Two fields swapped in the kernel leave the size as it was: the offsets must show it.
#[test]
fn a_swapped_pair_of_fields_is_found() {
    let swapped = Material::glsl()
        .replace(" kind;", " swap;")
        .replace(" fresnel;", " kind;")
        .replace(" swap;", " fresnel;");
    for theirs in nagas::<Material>(&swapped) {
        assert_eq!(theirs.size, ours::<Material>().size);
        assert_ne!(theirs, ours::<Material>());
    }
}
