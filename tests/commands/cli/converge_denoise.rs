//! `converge --vary denoise=…`: denoised pictures are judged as any others are, their seconds counted.

use serde_json::Value;

use super::denoise::SCENE;
use super::program::{folder, words};

#[test]
fn denoised_pictures_are_measured_and_their_bias_is_printed() {
    let folder = folder(SCENE);
    let line = "converge scene.scn --connect bsdf --vary denoise=off,nlm --spp 16 --replicates 3 --time 5 --device cpu-f32 --json c.json";
    let run = words(folder.path(), line);
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert!(
        run.err
            .contains("denoised pictures converge to a biased picture"),
        "{}",
        run.err
    );
    let text = std::fs::read_to_string(folder.path().join("c.json")).expect("a report");
    let record: Value = serde_json::from_str(&text).expect("JSON");
    let variants = record["variants"].as_array().expect("variants");
    let last = |i: usize| {
        let steps = variants[i]["steps"].as_array().expect("steps");
        let step = steps.iter().find(|step| step["spp"] == 16);
        step.expect("16 samples").clone()
    };
    let number = |value: &Value| value.as_f64().expect("a number");
    let (noisy, denoised) = (last(0), last(1));
    let error = |step: &Value| {
        let replicates = step["errors"]["rel_mse"]["replicates"].as_array();
        replicates.expect("a list").iter().map(number).sum::<f64>()
    };
    assert!(error(&denoised) < error(&noisy) / 2.0, "{denoised} {noisy}");
    assert_eq!(variants[1]["name"], "denoise=nlm");
}

#[test]
fn a_denoiser_that_is_not_there_is_refused() {
    let folder = folder(SCENE);
    let line =
        "converge scene.scn --vary denoise=oidn --oidn nowhere --spp 4 --time 1 --device cpu-f32";
    let run = words(folder.path(), line);
    assert_eq!(run.code, Some(2));
    assert!(
        run.err.contains("--oidn nowhere: lib") && run.err.contains("does not exist"),
        "{}",
        run.err
    );
}
