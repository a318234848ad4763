//! The operations that a device must do like the host, and how the host does them.

/// An operation on floats.
pub struct Float {
    pub name: &'static str,
    pub expression: &'static str,
    pub operands: usize,
    pub host: fn([f32; 3]) -> f32,
    pub truth: fn([f64; 3]) -> f64,
    /// Units of the last place from the truth (Vulkan 1.3, "Precision and Operation of SPIR-V Instructions").
    pub allowed: f64,
}

/// An operation on words, which has one right result.
pub struct Word {
    pub name: &'static str,
    pub expression: &'static str,
    pub host: fn([u32; 3]) -> u32,
    /// Whether a rendering kernel uses it.
    pub relied_on: bool,
}

/// Correctly rounded.
pub const EXACT: f64 = 0.5;

/// A row of the tables of floats.
const fn float(
    name: &'static str,
    expression: &'static str,
    operands: usize,
    host: fn([f32; 3]) -> f32,
    truth: fn([f64; 3]) -> f64,
    allowed: f64,
) -> Float {
    Float {
        name,
        expression,
        operands,
        host,
        truth,
        allowed,
    }
}

/// A row of the table of words.
const fn word(name: &'static str, expression: &'static str, host: fn([u32; 3]) -> u32) -> Word {
    Word {
        name,
        expression,
        host,
        relied_on: true,
    }
}

/// One that no kernel relies on.
const fn avoided(name: &'static str, expression: &'static str, host: fn([u32; 3]) -> u32) -> Word {
    Word {
        relied_on: false,
        ..word(name, expression, host)
    }
}

pub const FLOATS: [Float; 7] = [
    float(
        "x + y",
        "x + y",
        2,
        |[x, y, _]| x + y,
        |[x, y, _]| x + y,
        EXACT,
    ),
    float(
        "x − y",
        "x - y",
        2,
        |[x, y, _]| x - y,
        |[x, y, _]| x - y,
        EXACT,
    ),
    float(
        "x × y",
        "x * y",
        2,
        |[x, y, _]| x * y,
        |[x, y, _]| x * y,
        EXACT,
    ),
    float(
        "x ÷ y",
        "x / y",
        2,
        |[x, y, _]| x / y,
        |[x, y, _]| x / y,
        2.5,
    ),
    // Inherited from 1/inversesqrt(x): 2 ulp of the one, 2.5 of the other.
    float(
        "√x",
        "sqrt(x)",
        1,
        |[x, ..]| x.sqrt(),
        |[x, ..]| x.sqrt(),
        4.5,
    ),
    float(
        "⌊x⌋",
        "floor(x)",
        1,
        |[x, ..]| x.floor(),
        |[x, ..]| x.floor(),
        EXACT,
    ),
    float(
        "x < y",
        "(x < y ? 1.0 : 0.0)",
        2,
        |[x, y, _]| f32::from(u8::from(x < y)),
        |[x, y, _]| f64::from(u8::from(x < y)),
        EXACT,
    ),
];

/// Operations that only a compiler that respects `NoContraction` gets right.
pub const AS_WRITTEN: [Float; 2] = [
    float(
        "x·y + z in two roundings",
        "x * y + z",
        3,
        |[x, y, z]| x * y + z,
        |[x, y, z]| f64::from((x * y) as f32) + z,
        EXACT,
    ),
    float(
        "(x + y) − x as written",
        "(x + y) - x",
        2,
        |[x, y, _]| (x + y) - x,
        |[x, y, _]| f64::from((x + y) as f32) - x,
        EXACT,
    ),
];

pub const WORDS: [Word; 9] = [
    word(
        "float of a uint below 2³¹",
        "floatBitsToUint(float(w.x >> 1u))",
        |w| ((w[0] >> 1) as f32).to_bits(),
    ),
    // SwiftShader rounds these twice. A kernel converts words of 24 bits, and counts of samples.
    avoided(
        "float of a larger uint",
        "floatBitsToUint(float(w.x | 0x80000000u))",
        |w| ((w[0] | 0x8000_0000) as f32).to_bits(),
    ),
    word("float of an int", "floatBitsToUint(float(int(w.x)))", |w| {
        (w[0] as i32 as f32).to_bits()
    }),
    // The bits of a float in [0, 2³²), of one in (−2³¹, 2³¹).
    word(
        "uint of a float",
        "uint(uintBitsToFloat(w.x % 0x4f800000u))",
        |w| f32::from_bits(w[0] % 0x4f80_0000) as u32,
    ),
    word(
        "int of a float",
        "uint(int(uintBitsToFloat(w.x % 0x4f000000u | (w.y & 0x80000000u))))",
        |w| f32::from_bits((w[0] % 0x4f00_0000) | (w[1] & 0x8000_0000)) as i32 as u32,
    ),
    word("uint × uint + uint", "w.x * w.y + w.z", |w| {
        w[0].wrapping_mul(w[1]).wrapping_add(w[2])
    }),
    word(
        "uint ÷ uint, remainder",
        "w.x / (w.y | 1u) ^ w.x % (w.z | 1u)",
        |w| (w[0] / (w[1] | 1)) ^ (w[0] % (w[2] | 1)),
    ),
    word(
        "shifts",
        "(w.x << (w.y & 31u)) ^ (w.x >> (w.z & 31u)) ^ uint(int(w.y) >> (w.z & 31u))",
        |w| w[0] << (w[1] & 31) ^ w[0] >> (w[2] & 31) ^ (w[1] as i32 >> (w[2] & 31)) as u32,
    ),
    word("bitfieldReverse", "bitfieldReverse(w.x)", |w| {
        w[0].reverse_bits()
    }),
];
