//! Numbers that the host and the kernels must agree on, each declared once: a `const` in Rust and one in GLSL.
//!
//! A shader that says `// uses: constants/NAME` gets those of the module NAME, as [`glsl`] writes them.

/// A number as GLSL writes it.
trait Literal: Copy {
    const TYPE: &'static str;
    fn literal(self) -> String;
}

impl Literal for u32 {
    const TYPE: &'static str = "uint";
    fn literal(self) -> String {
        format!("{self}u")
    }
}

impl Literal for f64 {
    const TYPE: &'static str = "float";
    fn literal(self) -> String {
        format!("{self:?}")
    }
}

/// A line of GLSL that declares `name`.
fn line<T: Literal>(name: &str, value: T) -> String {
    format!("const {} {name} = {};\n", T::TYPE, value.literal())
}

/// The declaration of an unsigned constant in GLSL, in the format of [`glsl`].
pub fn uint(name: &str, value: u32) -> String {
    line(name, value)
}

macro_rules! constants {
    ($(
        $(#[doc = $about:literal])*
        mod $module:ident {
            $( $(#[doc = $doc:literal])* $name:ident: $ty:ty = $value:expr; )*
        }
    )*) => {
        $(
            $(#[doc = $about])*
            pub mod $module {
                $( $(#[doc = $doc])* pub const $name: $ty = $value; )*
            }
        )*

        /// The text of a module in GLSL; `None` if there is no such module.
        pub fn glsl(module: &str) -> Option<String> {
            match module {
                $( stringify!($module) => Some([
                    super::comment(&[$($about),*], ""),
                    $( super::comment(&[$($doc),*], ""), line(stringify!($name), $module::$name), )*
                ].concat()), )*
                _ => None,
            }
        }
    };
}

constants! {
    /// The value of an absent index.
    mod none {
        /// No shape, no primitive, or air.
        NONE: u32 = u32::MAX;
    }

    /// The size of a workgroup.
    mod workgroup {
        /// Threads per workgroup, in every kernel that renders or examines a device.
        WORKGROUP: u32 = 64;
    }

    /// Rays: their maximum length, and their start relative to a shape.
    mod ray {
        /// Farther than anything: the limit of an unlimited ray.
        FAR: f64 = 3.0e38;
        /// If a component of a unit vector is below this, it moves no ray by a noticeable part of its length: the ray
        /// counts as parallel, and no quotient overflows.
        PARALLEL: f64 = 1e-30;
        /// The ray does not start on a surface, or not on that of the shape in question.
        START_ELSEWHERE: u32 = 0;
        /// The ray starts on the shape's surface and leaves to its outside.
        START_OUTSIDE: u32 = 1;
        /// The ray starts on the shape's surface and leaves to its inside.
        START_INSIDE: u32 = 2;
    }

    /// Parts of a cylinder, as a hit's primitive names them.
    mod cylinder {
        CYLINDER_SIDE: u32 = 0;
        /// The cap at z = 0.
        CYLINDER_BASE: u32 = 1;
        /// The cap at z = height.
        CYLINDER_TOP: u32 = 2;
    }

    /// The part of a BSDF that a direction was sampled from.
    mod lobe {
        /// No direction was found: the path ends.
        LOBE_NONE: u32 = 0;
        LOBE_DIFFUSE: u32 = 1;
        LOBE_REFLECTION: u32 = 2;
        LOBE_TRANSMISSION: u32 = 3;
        /// Flag added to the lobe: the direction has no density, so no light connection could have found it.
        LOBE_DELTA: u32 = 4;
    }

    /// Limits of a path's bounces and random numbers.
    mod path {
        /// From this bounce on a path survives with probability .95 at most: a lossless one (light in a smooth glass
        /// box, two mirrors) would never end (model.md, "Roulette").
        LONG_PATH: u32 = 1000;
        /// The blocks of random numbers of a light path begin here, far beyond those of any eye path, also after the
        /// multiplication by GROUPS in sampler/sobol.
        LIGHT_PATH: u32 = 1 << 30;
    }

    /// The decisions of a path that enter its signature.
    mod decision {
        DECISION_SHAPE: u32 = 1;
        DECISION_LIGHT: u32 = 2;
        DECISION_ARRIVAL: u32 = 3;
        DECISION_LOBE: u32 = 4;
        DECISION_ESCAPE: u32 = 5;
        /// A throughput, or radiance in W·sr⁻¹·m⁻², below this counts as dark: 2⁻⁶⁴. The smallest normal f32 is 2⁻¹²⁶;
        /// this leaves 2⁶² for further factors: the radiance of a light or the inverse of a density.
        DARK: f64 = 5.421010862427522e-20;
    }

    /// Picking the light that a vertex is connected to.
    mod lights {
        /// Up to this number, each light is a candidate at every vertex; more are searched in a tree.
        FEW_LIGHTS: u32 = 16;
    }

    /// Bidirectional paths.
    mod bidirectional {
        /// Vertices of a light path that are kept for eye paths: two give 92 to 97 % of the contribution of all.
        KEPT: u32 = 2;
    }

    /// The events of `--trace`.
    mod record {
        RECORD_VERTEX: u32 = 1;
        RECORD_CONNECTION: u32 = 2;
        RECORD_ESCAPE: u32 = 3;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_module_in_glsl_has_the_lines_of_its_declaration() {
        let expected = "\
// Parts of a cylinder, as a hit's primitive names them.
const uint CYLINDER_SIDE = 0u;
// The cap at z = 0.
const uint CYLINDER_BASE = 1u;
// The cap at z = height.
const uint CYLINDER_TOP = 2u;
";
        assert_eq!(glsl("cylinder").as_deref(), Some(expected));
        assert_eq!(glsl("nonesuch"), None);
    }

    /// naga parses a literal as f32 with a single rounding, like `as f32`.
    #[test]
    fn numbers_are_written_as_they_are() {
        assert_eq!(
            line("X", decision::DARK),
            "const float X = 5.421010862427522e-20;\n"
        );
        assert_eq!(decision::DARK, (-64.0f64).exp2());
        assert_eq!(line("X", ray::FAR), "const float X = 3e38;\n");
        assert_eq!(line("X", none::NONE), "const uint X = 4294967295u;\n");
    }
}
