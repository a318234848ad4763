//! `vkpt converge`: the table, the files, and how it ends.

use std::fs;
use std::path::Path;

use serde_json::Value;

use super::program::{Run, command, finish, folder, names, run};

/// A room with a lamp, small enough for the reference renderer.
pub const LIT: &str = "screen 12 8\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 2 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";
/// Some milliseconds of samples, and a second for the reference unless one is given; needs no Vulkan.
const SMALL: [&str; 6] = ["scene.scn", "--device", "cpu-f32", "--spp", "8", "--time=1"];

/// Without a cache of references.
fn converge(folder: &Path, more: &[&str]) -> Run {
    with_cache(folder, "", more)
}

fn with_cache(folder: &Path, cache: &str, more: &[&str]) -> Run {
    let arguments = [&["converge"], &SMALL[..], more].concat();
    let mut command = command(folder, &arguments);
    finish(command.env("VKPT_CACHE", cache))
}

fn json(folder: &Path, name: &str) -> Value {
    let text = fs::read_to_string(folder.join(name)).expect("a report");
    serde_json::from_str(&text).expect("JSON")
}

/// A picture of 512 samples per pixel and its standard errors, by other random numbers.
pub fn reference(folder: &Path, name: &str) {
    let arguments =
        "scene.scn --device cpu-f32 --spp 512 --seed 77 --aov stderr --sampler random --quiet -o";
    let arguments: Vec<&str> = arguments.split(' ').chain([name]).collect();
    assert_eq!(run(folder, &arguments).code, Some(0));
}

#[test]
fn a_curve_goes_to_table_csv_and_json() {
    let folder = folder(LIT);
    let folder = folder.path();
    reference(folder, "r.exr");
    let files = "--reference r.exr --csv c.csv --json c.json --svg c.svg".split(' ');
    let files: Vec<&str> = files.collect();
    let done = converge(folder, &files);
    assert_eq!(done.code, Some(0), "{}", done.err);
    for word in [
        "8 replicates, seeds 0 to 7",
        "relMSE",
        "slope",
        "r.exr",
        "no evidence against",
        "of at most 1.00 s of sampling used",
    ] {
        assert!(done.out.contains(word), "{word}: {}", done.out);
    }
    assert!(
        done.out.lines().all(|l| l.chars().count() <= 130),
        "{}",
        done.out
    );

    let record = json(folder, "c.json");
    assert!(record["spent_s"].as_f64().is_some_and(|s| s > 0.0));
    let steps = record["variants"][0]["steps"].as_array().expect("steps");
    let spp: Vec<_> = steps.iter().filter_map(|s| s["spp"].as_u64()).collect();
    assert_eq!(spp, [1, 2, 4, 8]);
    let mean = |step: &Value, metric: &str| step["errors"][metric]["mean"]["value"].as_f64();
    for step in steps {
        for metric in ["mse", "rmse", "rel_mse", "smape", "flip"] {
            let error = &step["errors"][metric];
            let replicates: Vec<f64> = error["replicates"]
                .as_array()
                .expect("replicates")
                .iter()
                .filter_map(Value::as_f64)
                .collect();
            assert_eq!(replicates.len(), 8);
            let expected = replicates.iter().sum::<f64>() / 8.0;
            let found = mean(step, metric).expect("a mean");
            assert!((found - expected).abs() <= 1e-12 * expected, "{metric}");
        }
        assert!(step["wall_s"]["value"].as_f64().is_some_and(|s| s > 0.0));
        assert!(step["gpu_s"].is_null());
    }
    assert!(mean(&steps[3], "rel_mse") < mean(&steps[0], "rel_mse"));

    let csv = fs::read_to_string(folder.join("c.csv")).expect("a table");
    let columns = |line: &str| line.split(',').count();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 5);
    assert!(
        lines.iter().all(|line| columns(line) == columns(lines[0])),
        "{csv}"
    );
    assert!(lines[0].starts_with("variant,spp,wall_s,"));

    let svg = fs::read_to_string(folder.join("c.svg")).expect("a plot");
    assert!(svg.starts_with("<svg ") && svg.contains("scene.scn") && svg.ends_with("</svg>\n"));
}

/// A lamp a tenth darker than the reference's: reported outside the table, without an error.
#[test]
fn a_curve_that_does_not_converge_is_a_warning_and_a_field() {
    let folder = folder(&LIT.replace("9 8 7", "10 8.9 7.8"));
    let folder = folder.path();
    reference(folder, "brighter.exr");
    fs::write(folder.join("scene.scn"), LIT).expect("a scene");
    reference(folder, "right.exr");
    let quiet = |reference| {
        let more = [
            "--spp=64",
            "--quiet",
            "--json=c.json",
            "--reference",
            reference,
        ];
        let arguments = "converge scene.scn --device cpu-f32 --time 9";
        let arguments: Vec<&str> = arguments.split(' ').chain(more).collect();
        let run = run(folder, &arguments);
        let converges = json(folder, "c.json")["variants"][0]["converges"].clone();
        (run.code, run.out, run.err, converges)
    };
    let nothing = String::new();
    assert_eq!(
        quiet("right.exr"),
        (Some(0), nothing.clone(), nothing.clone(), true.into())
    );
    let (code, out, err, converges) = quiet("brighter.exr");
    assert_eq!((code, out, converges), (Some(0), nothing, false.into()));
    let message = "warning: the pictures do not converge to the reference (brighter.exr): relMSE ";
    assert!(err.starts_with(message), "{err}");
    assert_eq!(err.lines().count(), 1, "{err}");
}

/// The errors that it prints are those of the picture that `vkpt SCENE` renders, by `vkpt compare`'s numbers.
#[test]
fn a_replicate_is_the_picture_of_its_seed() {
    let folder = folder(LIT);
    let folder = folder.path();
    reference(folder, "r.exr");
    fs::remove_file(folder.join("r-stderr.exr")).expect("standard errors");
    let more = [
        "--reference",
        "r.exr",
        "--json",
        "c.json",
        "--seed",
        "5",
        "--quiet",
    ];
    let quiet = converge(folder, &more);
    assert_eq!(
        (quiet.code, quiet.out.as_str()),
        (Some(0), ""),
        "{}",
        quiet.err
    );
    let render = "scene.scn --device cpu-f32 --spp 4 --seed 7 -o a.exr --quiet";
    let render: Vec<&str> = render.split(' ').collect();
    assert_eq!(run(folder, &render).code, Some(0));
    let compared = run(folder, &["compare", "a.exr", "r.exr"]).out;
    let printed = |metric: &str| -> f64 {
        let line = compared
            .lines()
            .find(|l| l.starts_with(metric))
            .expect("a row");
        let word = line.split_whitespace().nth(1).expect("a number");
        word.parse().expect("a number")
    };
    let errors = &json(folder, "c.json")["variants"][0]["steps"][2]["errors"];
    for (name, row) in [
        ("mse", "MSE"),
        ("rel_mse", "relMSE"),
        ("smape", "SMAPE"),
        ("flip", "FLIP"),
    ] {
        // The third replicate has seed 7.
        let found = errors[name]["replicates"][2].as_f64().expect("an error");
        assert!(
            (found / printed(row) - 1.0).abs() < 1e-3,
            "{name}: {found}\n{compared}"
        );
    }
}

#[test]
fn variants_are_compared_with_the_first() {
    let folder = folder(LIT);
    let more = "--vary connect=light,bsdf --vary lobe=fresnel,norms --json c.json --replicates 4";
    let done = converge(folder.path(), &more.split(' ').collect::<Vec<_>>());
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(
        done.out.contains("relative to connect=light lobe=fresnel"),
        "{}",
        done.out
    );
    assert!(
        !done.out.contains("converge to different limits"),
        "{}",
        done.out
    );
    let record = json(folder.path(), "c.json");
    let variants = record["variants"].as_array().expect("variants");
    let names: Vec<_> = variants.iter().filter_map(|v| v["name"].as_str()).collect();
    let all = [
        "connect=light lobe=fresnel",
        "connect=light lobe=norms",
        "connect=bsdf lobe=fresnel",
        "connect=bsdf lobe=norms",
    ];
    assert_eq!(names, all);
    assert!(variants[0]["against_first"].is_null());
    // A lamp of half a unit's radius: paths seldom find it by chance.
    let ratio = variants[2]["against_first"]["high"].as_f64();
    assert!(ratio.is_some_and(|high| high < 1.0), "{}", done.out);
    assert!(done.out.contains("worse"), "{}", done.out);
}

#[test]
fn where_the_model_varies_it_says_that_the_limits_differ() {
    let folder = folder(LIT);
    let more = ["--vary", "max-depth=1,4", "--replicates", "3"];
    let done = converge(folder.path(), &more);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(
        done.out.contains("converge to different limits"),
        "{}",
        done.out
    );
    assert_eq!(names(folder.path()), ["scene.scn"]);
}

/// The second run has the first's reference, to the bit; not where its file is broken, the scene or the model another.
#[test]
fn references_are_kept_and_trusted_only_whole() {
    let folder = folder(LIT);
    let folder = folder.path();
    let own = |more: &[&str]| {
        let more = [&["--json", "c.json", "--replicates", "2"], more].concat();
        let done = with_cache(folder, "cache", &more);
        assert_eq!(done.code, Some(0), "{}", done.err);
        let reference = json(folder, "c.json")["variants"][0]["reference"].clone();
        let name = reference["name"].as_str().expect("a name").to_owned();
        (name.contains("cached"), reference["own"].clone())
    };
    let (kept, first) = own(&[]);
    assert!(!kept);
    assert_eq!(own(&[]), (true, first.clone()));
    assert!(!own(&["--max-depth", "2"]).0);
    assert!(!own(&["--crop", "0,0,4,4"]).0);
    assert_eq!(own(&["--seed", "9", "--connect", "light"]), (true, first));
    for entry in fs::read_dir(folder.join("cache/references"))
        .expect("a cache")
        .flatten()
    {
        let mut bytes = fs::read(entry.path()).expect("a file");
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        fs::write(entry.path(), bytes).expect("broken");
    }
    assert!(!own(&[]).0, "broken");
    fs::write(folder.join("scene.scn"), LIT.replace("9 8 7", "9 8 6")).expect("a scene");
    assert!(!own(&[]).0, "another scene");
}
