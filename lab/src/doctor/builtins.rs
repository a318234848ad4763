//! GLSL's own elementary functions, their true values, and the errors that Vulkan allows.

use Allowed::{Absolute, Anything, Relative, Ulps};
use Arguments::{Bits, Even, With};

/// Arguments of each function.
pub const ROWS: u32 = 1 << 18;

/// A function, the range examined, and the error that Vulkan allows.
pub struct Builtin {
    pub name: &'static str,
    pub expression: &'static str,
    pub range: &'static str,
    pub arguments: Arguments,
    pub truth: fn(f64, f64) -> f64,
    pub allowed: Allowed,
    pub words: &'static str,
}

pub enum Arguments {
    /// Evenly from one to the other.
    Even(f64, f64),
    /// Evenly by their bits, that is, by their logarithms.
    Bits(u32, u32),
    /// Evenly, with a second argument.
    With(f64, f64, f32),
}

/// Bounds of Vulkan 1.3, "Precision and Operation of SPIR-V Instructions", as functions of arguments and truth.
pub enum Allowed {
    Ulps(fn(f64) -> f64),
    Absolute(f64),
    Relative(fn(f64, f64) -> f64),
    Anything,
}

/// A row of the table.
const fn builtin(
    name: &'static str,
    expression: &'static str,
    range: &'static str,
    arguments: Arguments,
    truth: fn(f64, f64) -> f64,
    allowed: Allowed,
    words: &'static str,
) -> Builtin {
    Builtin {
        name,
        expression,
        range,
        arguments,
        truth,
        allowed,
        words,
    }
}

/// All positive normal numbers.
const POSITIVE: Arguments = Bits(0x0080_0000, 0x7f7f_ffff);
const TRIGONOMETRIC: &str = "2⁻¹¹ absolute";
const PI: f64 = std::f64::consts::PI;

pub const BUILTINS: [Builtin; 14] = [
    builtin(
        "sin",
        "sin(x)",
        "[−π, π]",
        Even(-PI, PI),
        |x, _| x.sin(),
        Absolute(1.0 / 2048.0),
        TRIGONOMETRIC,
    ),
    builtin(
        "cos",
        "cos(x)",
        "[−π, π]",
        Even(-PI, PI),
        |x, _| x.cos(),
        Absolute(1.0 / 2048.0),
        TRIGONOMETRIC,
    ),
    builtin(
        "sin",
        "sin(x)",
        "[0, 1000]",
        Even(0.0, 1000.0),
        |x, _| x.sin(),
        Anything,
        "anything",
    ),
    builtin(
        "tan",
        "tan(x)",
        "[−1.5, 1.5]",
        Even(-1.5, 1.5),
        |x, _| x.tan(),
        Anything,
        "as sin/cos",
    ),
    builtin(
        "acos",
        "acos(x)",
        "[−1, 1]",
        Even(-1.0, 1.0),
        |x, _| x.acos(),
        Anything,
        "as atan(√(1 − x²), x)",
    ),
    builtin(
        "atan",
        "atan(x)",
        "[−1e3, 1e3]",
        Even(-1e3, 1e3),
        |x, _| x.atan(),
        Ulps(|_| 4096.0),
        "4096 ulp",
    ),
    builtin(
        "exp",
        "exp(x)",
        "[−87, 88]",
        Even(-87.0, 88.0),
        |x, _| x.exp(),
        Ulps(|x| 3.0 + 2.0 * x.abs()),
        "3 + 2|x| ulp",
    ),
    builtin(
        "exp2",
        "exp2(x)",
        "[−126, 127]",
        Even(-126.0, 127.0),
        |x, _| x.exp2(),
        Ulps(|x| 3.0 + 2.0 * x.abs()),
        "3 + 2|x| ulp",
    ),
    builtin(
        "log",
        "log(x)",
        "[2, 3e38]",
        Bits(0x4000_0000, 0x7f7f_ffff),
        |x, _| x.ln(),
        Ulps(|_| 3.0),
        "3 ulp",
    ),
    builtin(
        "log",
        "log(x)",
        "[1/2, 2]",
        Even(0.5, 2.0),
        |x, _| x.ln(),
        Absolute(1.0 / 2097152.0),
        "2⁻²¹ absolute",
    ),
    builtin(
        "log2",
        "log2(x)",
        "[1/2, 2]",
        Even(0.5, 2.0),
        |x, _| x.log2(),
        Absolute(1.0 / 2097152.0),
        "2⁻²¹ absolute",
    ),
    builtin(
        "pow, to 2000",
        "pow(x, y)",
        "[0.96, 1]",
        With(0.96, 1.0, 2000.0),
        f64::powf,
        Relative(power),
        "as exp2(y·log2 x)",
    ),
    builtin(
        "inversesqrt",
        "inversesqrt(x)",
        "positive",
        POSITIVE,
        |x, _| 1.0 / x.sqrt(),
        Ulps(|_| 2.0),
        "2 ulp",
    ),
    builtin(
        "length",
        "length(vec3(x, 1.0, y))",
        "[−1e3, 1e3]",
        With(-1e3, 1e3, 0.3),
        |x, y| (x * x + 1.0 + y * y).sqrt(),
        Anything,
        "as √(v·v)",
    ),
];

/// exp2(y·log2 x) near x = 1: log2 is off by 2⁻²¹, the product by half a unit, exp2 by 3 + 2|t| units, of 2⁻²³.
fn power(x: f64, y: f64) -> f64 {
    let t = (y * x.log2()).abs();
    let exponent = y * 2f64.powi(-21) + t * 2f64.powi(-24);
    (std::f64::consts::LN_2 * exponent).exp_m1() + (3.0 + 2.0 * t) * 2f64.powi(-23)
}

impl Arguments {
    /// The words of row i.
    pub fn row(&self, i: u32) -> [u32; 3] {
        let share = f64::from(i) / f64::from(ROWS - 1);
        let even = |from: f64, to: f64| ((from + (to - from) * share) as f32).to_bits();
        match *self {
            Self::Even(from, to) => [even(from, to), 0, 0],
            Self::With(from, to, y) => [even(from, to), y.to_bits(), 0],
            Self::Bits(from, to) => [from + (f64::from(to - from) * share) as u32, 0, 0],
        }
    }
}
