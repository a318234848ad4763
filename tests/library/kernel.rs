//! Composing and compiling kernels: order, errors in the original file, and what must hold for the SPIR-V words.

use std::collections::BTreeSet;

use vkpt::kernel::{Composed, Composer, KernelError, Slot, Spirv, compile, files, unaudited};

use crate::common::spirv_tools::{tool, try_tool};

const HEADER: &str = "layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) buffer Words { float w[]; } words;
";

fn kernel(body: &str) -> Result<Composed, KernelError> {
    Composer::new()
        .prelude(HEADER)
        .add("root", body)
        .compose(&["root"])
}

fn spirv(body: &str) -> Spirv {
    kernel(body)
        .and_then(|k| compile(&k))
        .expect("a valid kernel")
}

// ---- composition

fn diamond() -> Composer {
    Composer::new()
        .add("a", "// uses: b, c\nvoid main() { fb(); fc(); }\n")
        .add("b", "// uses: d\nvoid fb() { fd(); }\n")
        .add("c", "// uses: d, <s>\nvoid fc() { fd(); fs(); }\n")
        .add("d", "void fd() {}\n")
        .add("e", "void fe() {}\n")
}

#[test]
fn each_file_comes_once_after_all_that_it_uses() {
    let text = "// uses: e\nvoid fs() { fe(); }\n";
    let composer = diamond()
        .prelude("// prelude\n")
        .slot("s", Slot::Text(text.into()));
    let kernel = composer.compose(&["a"]).expect("composes");
    let files: Vec<&str> = kernel.files().collect();
    assert_eq!(files, ["<prelude>", "d", "b", "e", "<s>", "c", "a"]);
    assert!(
        kernel
            .text()
            .starts_with("#version 450\n// prelude\nvoid fd() {}\n")
    );
    compile(&kernel).expect("compiles");
}

#[test]
fn a_slot_may_be_a_file_that_is_also_used_by_name() {
    let composer = diamond().add("d2", "// uses: d\nvoid fs() { fd(); }\n");
    let kernel = composer
        .slot("s", Slot::File("d2".into()))
        .compose(&["a", "d2"])
        .expect("composes");
    assert_eq!(kernel.files().filter(|f| *f == "d2").count(), 1);
}

#[test]
fn missing_files_are_named_with_the_file_that_uses_them() {
    let unknown = Composer::new()
        .add("a", "// uses: math/nonesuch\n")
        .compose(&["a"])
        .unwrap_err();
    assert_eq!(
        unknown,
        KernelError::UnknownFile {
            name: "math/nonesuch".into(),
            asked_by: "a".into()
        }
    );
    let slot = diamond().compose(&["a"]).unwrap_err();
    assert_eq!(
        slot,
        KernelError::UnknownSlot {
            slot: "s".into(),
            asked_by: "c".into()
        }
    );
    let root = Composer::new().compose(&["nonesuch.comp"]).unwrap_err();
    assert!(
        root.to_string()
            .starts_with("the kernel uses nonesuch.comp"),
        "{root}"
    );
}

#[test]
fn a_cycle_is_reported_whole() {
    let circle = diamond()
        .add("d", "// uses: a\n")
        .compose(&["a"])
        .unwrap_err();
    let chain = ["a", "b", "d", "a"].map(String::from).to_vec();
    assert_eq!(circle, KernelError::Cycle { chain });
}

// ---- errors in the original file

#[test]
fn a_syntax_error_is_shown_in_its_own_file() {
    let composer = Composer::new()
        .prelude(HEADER)
        .add(
            "lib",
            "// Länge: ε ≤ 1, drei Zeilen.\nfloat twice(float x) {\n    return 2.0 * y;\n}\n",
        )
        .add(
            "root",
            "// uses: lib\nvoid main() { words.w[0] = twice(1.0); }\n",
        );
    let error = composer
        .compose(&["root"])
        .and_then(|k| compile(&k))
        .unwrap_err();
    let expected = "GLSL: \nUnknown variable: y\n  --> lib:3\n   |     return 2.0 * y;";
    assert_eq!(error.to_string(), expected);
}

#[test]
fn a_panic_of_naga_is_an_error() {
    let inout = "void grow(inout float x) { x += 1.0; }
void main() { vec3 v = vec3(0.0); grow(v.x); words.w[0] = v.x; }\n";
    let error = kernel(inout).and_then(|k| compile(&k)).unwrap_err();
    assert!(matches!(error, KernelError::Panic(_)), "{error:?}");
}

#[test]
fn a_kernel_without_main_is_refused() {
    let error = kernel("").and_then(|k| compile(&k)).unwrap_err();
    assert!(error.to_string().contains("Missing entry point"), "{error}");
}

// ---- choices of a driver

#[test]
fn driver_maths_is_refused_where_it_stands() {
    for (expression, name) in [
        ("sin(x)", "Sin"),
        ("exp(x)", "Exp"),
        ("pow(x, 2.0)", "Pow"),
        ("inversesqrt(x)", "InverseSqrt"),
        ("fma(x, x, x)", "Fma"),
        ("min(x, 1.0)", "Min"),
        ("max(x, 1.0)", "Max"),
        ("clamp(x, 0.0, 1.0)", "Clamp"),
        ("mix(x, 1.0, x)", "Mix"),
        ("sign(x)", "Sign"),
        ("length(vec3(x))", "Length"),
        ("dot(vec3(x), vec3(x))", "Dot"),
        ("normalize(vec3(x)).x", "Normalize"),
        ("cross(vec3(x), vec3(x)).x", "Cross"),
    ] {
        let body = format!(
            "void main() {{\n    float x = words.w[1];\n    words.w[0] = {expression};\n}}\n"
        );
        match kernel(&body).and_then(|k| compile(&k)) {
            Err(KernelError::DriverMaths(culprits)) => {
                assert_eq!(culprits[0].message, name);
                assert_eq!((culprits[0].file.as_str(), culprits[0].line), ("root", 3));
            }
            other => panic!("{expression}: {other:?}"),
        }
    }
}

#[test]
fn exact_functions_are_allowed() {
    let body = "void main() {
    float x = words.w[1];
    uint i = floatBitsToUint(x);
    words.w[0] = abs(x) + floor(x) + sqrt(x) + uintBitsToFloat(max(min(i, 7u), 3u)) + float(findMSB(i));
}\n";
    spirv(body);
}

// ---- SPIR-V

const ARITHMETIC: &str = "vec3 scaled(vec3 v, float k) { return -(v * k) / k; }
float unused(float x) { return x + x; }
void main() {
    uint i = gl_GlobalInvocationID.x * 3u + 1u;
    float stack[8];
    uint top = 0u;
    while (top < 8u) { stack[top] = words.w[i + top]; top += 1u; }
    float table[3] = float[3](0.0, 0.0, 0.0);
    float x = stack[i & 7u] - table[i % 3u];
    words.w[i] = x * x + scaled(vec3(x), 2.0).y;
}\n";

#[test]
fn functions_that_main_does_not_reach_are_left_out() {
    let spirv = spirv(ARITHMETIC);
    assert_eq!(spirv.functions, ["scaled"]);
    assert_eq!(spirv.workgroup_size, [64, 1, 1]);
}

/// SPIR-V's float arithmetic, by the names that spirv-dis prints.
const FLOAT_ARITHMETIC: [&str; 14] = [
    "OpFNegate",
    "OpFAdd",
    "OpFSub",
    "OpFMul",
    "OpFDiv",
    "OpFRem",
    "OpFMod",
    "OpVectorTimesScalar",
    "OpMatrixTimesScalar",
    "OpVectorTimesMatrix",
    "OpMatrixTimesVector",
    "OpMatrixTimesMatrix",
    "OpOuterProduct",
    "OpDot",
];

/// (float results without the decoration, decorated results that are no float arithmetic), by the
/// disassembly of the Khronos tool, which knows nothing of the pass.
fn uncontracted(disassembly: &str) -> (BTreeSet<&str>, BTreeSet<&str>) {
    let mut decorated = BTreeSet::new();
    let mut arithmetic = BTreeSet::new();
    for line in disassembly.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["OpDecorate", id, "NoContraction"] => {
                assert!(decorated.insert(id), "{id} decorated twice")
            }
            [id, "=", op, ..] if FLOAT_ARITHMETIC.contains(&op) => {
                arithmetic.insert(id);
            }
            _ => {}
        }
    }
    (&arithmetic - &decorated, &decorated - &arithmetic)
}

#[test]
fn no_contraction_stands_on_all_and_only_float_arithmetic() {
    let Some(text) = tool("spirv-dis", &["--raw-id"], spirv(ARITHMETIC).bytes()) else {
        return;
    };
    for op in [
        "OpFNegate",
        "OpFAdd",
        "OpFSub",
        "OpFMul",
        "OpFDiv",
        "OpVectorTimesScalar",
    ] {
        assert!(text.contains(op), "the example has no {op}");
    }
    assert_eq!(uncontracted(&text), (BTreeSet::new(), BTreeSet::new()));

    let line = text
        .lines()
        .find(|l| l.ends_with("NoContraction"))
        .expect("a decoration");
    let missing = text.replacen(&format!("{line}\n"), "", 1);
    assert_eq!(
        uncontracted(&missing).0.len(),
        1,
        "a missing decoration is not found"
    );
    let stray = format!("{text}\nOpDecorate %999999 NoContraction\n");
    assert_eq!(
        uncontracted(&stray).1.len(),
        1,
        "a stray decoration is not found"
    );
}

#[test]
fn only_arrays_without_an_initialiser_stay_undefined() {
    let Some(text) = tool("spirv-dis", &["--raw-id"], spirv(ARITHMETIC).bytes()) else {
        return;
    };
    let bare = text
        .lines()
        .filter(|l| l.trim_end().ends_with(" Function") && l.contains("OpVariable"))
        .count();
    assert_eq!(bare, 1, "{text}");
    // The zeros of `table` are in the text: as initialiser, or stored.
    assert!(
        text.contains("OpConstantComposite") || text.contains("OpCompositeConstruct"),
        "{text}"
    );
}

#[test]
fn spirv_val_accepts_the_words_and_refuses_broken_ones() {
    let good = spirv(ARITHMETIC);
    let Some(_) = tool("spirv-val", &["--target-env", "vulkan1.1"], good.bytes()) else {
        return;
    };
    let mut bad = good;
    let i = bad
        .words
        .iter()
        .position(|w| *w == 3 << 16 | 71)
        .expect("OpDecorate");
    bad.words[i + 1] = 1_000_000;
    let refused = try_tool("spirv-val", &["--target-env", "vulkan1.1"], bad.bytes());
    assert_eq!(refused.map(|r| r.is_err()), Some(true));
}

/// Every root in `shaders/` that is complete compiles and passes spirv-val. (Those whose buffers or
/// slots are generated for a scene are compiled by the tests of their own composer.)
#[test]
fn the_roots_of_shaders_are_valid() {
    for root in files().filter(|f| f.ends_with(".comp")) {
        // No kernel that renders has a barrier.
        let compiled = |k| match root {
            "doctor/barrier.comp" => unaudited::compile(&k, unaudited::Arithmetic::AsWritten),
            _ => compile(&k),
        };
        match Composer::new().compose(&[root]).and_then(compiled) {
            Ok(spirv) => {
                tool("spirv-val", &["--target-env", "vulkan1.1"], spirv.bytes());
            }
            Err(KernelError::UnknownSlot { .. } | KernelError::Glsl(_)) => {
                println!("{root}: needs its composer")
            }
            Err(e) => panic!("{root}: {e}"),
        }
    }
}
