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

/// The declaration of an unsigned constant in GLSL, as the lines of [`glsl`] are.
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

        /// The text of a module in GLSL; `None` where there is no such module.
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
    /// What stands where an index has nothing to say.
    mod none {
        /// No shape, no primitive, or air.
        NONE: u32 = u32::MAX;
    }

    /// The size of a workgroup.
    mod workgroup {
        /// Threads of one, in every kernel that renders or examines a device.
        WORKGROUP: u32 = 64;
    }

    /// Rays: how far they reach, and how one starts as a shape sees it.
    mod ray {
        /// Farther than anything: the limit of a ray that has none.
        FAR: f64 = 3.0e38;
        /// Below this a component of a unit vector moves no ray by a noticeable part of its length: the ray counts as
        /// parallel, and no quotient overflows.
        PARALLEL: f64 = 1e-30;
        /// It does not start on a surface, or not on that of the shape in question.
        START_ELSEWHERE: u32 = 0;
        /// It starts on the shape's surface and leaves to its outside.
        START_OUTSIDE: u32 = 1;
        /// It starts on the shape's surface and leaves to its inside.
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

    /// Which part of a BSDF a direction was drawn from.
    mod lobe {
        /// No direction was found: the path ends.
        LOBE_NONE: u32 = 0;
        LOBE_DIFFUSE: u32 = 1;
        LOBE_REFLECTION: u32 = 2;
        LOBE_TRANSMISSION: u32 = 3;
        /// Flag beside the lobe: the direction has no density, so no light connection could have found it.
        LOBE_DELTA: u32 = 4;
    }

    /// Numbers of a path's bounces and of its random numbers.
    mod path {
        /// From this bounce on a path survives with at most .95: a lossless one (light in a smooth glass box, two
        /// mirrors) would never end (model.md, "Roulette").
        LONG_PATH: u32 = 1000;
        /// The blocks of random numbers of a light path begin here, far beyond those of any eye path, also after the
        /// multiplication by GROUPS in sampler/sobol.
        LIGHT_PATH: u32 = 1 << 30;
    }

    /// The decisions of a path that its signature is made of.
    mod decision {
        DECISION_SHAPE: u32 = 1;
        DECISION_LIGHT: u32 = 2;
        DECISION_ARRIVAL: u32 = 3;
        DECISION_LOBE: u32 = 4;
        DECISION_ESCAPE: u32 = 5;
        /// What counts as no light, in a throughput or in W·sr⁻¹·m⁻²: 2⁻⁶⁴. The least normal number of f32 is 2⁻¹²⁶; that
        /// leaves 2⁶² for what a factor that small may be multiplied by, the radiance of a light or the inverse of a density.
        DARK: f64 = 5.421010862427522e-20;
    }

    /// How a vertex picks the light that it is connected to.
    mod lights {
        /// Up to so many each is a candidate at every vertex; more are searched in a tree.
        FEW_LIGHTS: u32 = 16;
    }

    /// Bidirectional paths.
    mod bidirectional {
        /// Vertices of a light path that are kept for eye paths: two bring 92 to 97 % of what all would.
        KEPT: u32 = 2;
    }

    /// What an entry of `--trace` is about.
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

    /// naga reads a literal as f32 and rounds once, as `as f32` does.
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
