//! A record as JSON, as lines to read and as a picture's header.

use serde_json::{Value, json};
use vkpt::film::Film;
use vkpt::report::{
    Dropped, ErrorAt, Job, Kernel, Largest, Machine, Memory, Record, SOFTWARE, Seconds, Work,
    concerns, noted_freedom, notes, stderr_notes, summary,
};
use vkpt::settings::{
    Connect, Distribution, DistributionRule, Fresnel, Roulette, Sampler, Settings,
};

fn record() -> Record {
    let seconds = Seconds {
        read: 0.012,
        prepare: 0.0,
        device: 0.0,
        hierarchy: 0.0,
        compose: 0.004,
        upload: 0.0,
        pipeline: 0.25,
        compile: 0.5,
        render: 7.5,
        gpu: Some(7.25),
        write: 0.02,
    };
    Record {
        version: "0.0.1".into(),
        job: Job {
            scene: "scenes/a.scn".to_owned(),
            camera: None,
            size: [400, 300],
            range: None,
            crop: None,
            spp: 64,
            spp_asked: 64,
            ended: "complete".into(),
            time: None,
            target_error: None,
            seed: 7,
            settings: (&Settings::default()).into(),
            auto: None,
        },
        machine: Machine {
            device: "llvmpipe".to_owned(),
            device_auto: None,
            driver: "Mesa 22.3.6".to_owned(),
            kernel: Some(Kernel {
                choice: "composed".into(),
                features: vec!["sphere".to_owned(), "ggx".to_owned()],
                spirv_bytes: 1234,
            }),
            memory: Memory {
                device: 4096,
                peak: None,
            },
        },
        work: Work::new(&seconds, 7_680_000, 40_000_000, Dropped::default(), 0, 0),
        seconds,
        largest: Some(Largest {
            radiance: 812.5,
            weight: 1300.0,
            pixel: [3, 4],
            sample: 17,
        }),
        error: vec![
            at(1, 0.1, None, None),
            at(64, 7.5, Some(3.1e-3), Some([2.76e-3, 3.54e-3])),
        ],
        denoised: None,
        files: vec!["a.png".to_owned()],
        warnings: Vec::new(),
    }
}

fn at(spp: u32, seconds: f64, rel_mse: Option<f64>, interval: Option<[f64; 2]>) -> ErrorAt {
    ErrorAt {
        spp,
        seconds,
        rel_mse,
        low: interval.map(|[low, _]| low),
        high: interval.map(|[_, high]| high),
        half_in_pixels: None,
        worst_pixel: None,
    }
}

#[test]
fn json_has_every_field_by_name() {
    let mut record = record();
    record.work.dropped = Dropped {
        nan: 1,
        infinite: 2,
        loops: 3,
    };
    record.job.crop = Some([0, 1, 2, 3]);
    let expected = json!({
        "version": "0.0.1",
        "scene": "scenes/a.scn",
        "size": [400, 300],
        "crop": [0, 1, 2, 3],
        "range": null,
        "spp": 64,
        "spp_asked": 64,
        "ended": "complete",
        "time": null,
        "target_error": null,
        "seed": 7,
        "auto": null,
        "settings": {
            "fresnel": "scene", "distribution": "scene", "absorption": "segment", "radiance_scaling": true,
            "max_depth": null, "integrator": "path", "lobe": "fresnel", "normals": "visible", "roulette": "throughput",
            "connect": "mis", "lights": "contribution", "sampler": "sobol",
        },
        "device": "llvmpipe",
        "device_auto": null,
        "driver": "Mesa 22.3.6",
        "kernel": {
            "choice": "composed",
            "features": ["sphere", "ggx"],
            "spirv_bytes": 1234,
        },
        "memory": { "device": 4096, "peak": null },
        "seconds": {
            "read": 0.012, "prepare": 0.0, "device": 0.0, "hierarchy": 0.0, "compose": 0.004, "upload": 0.0,
            "pipeline": 0.25, "compile": 0.5, "render": 7.5, "gpu": 7.25, "write": 0.02,
        },
        "samples": 7_680_000,
        "rays": 40_000_000,
        "samples_per_s": 960_000.0,
        "rays_per_s": 5_000_000.0,
        "dropped": { "nan": 1, "infinite": 2, "loop": 3 },
        "long_paths": 0,
        "underflows": 0,
        "largest": { "radiance": 812.5, "weight": 1300.0, "pixel": [3, 4], "sample": 17 },
        "error": [
            {
                "spp": 1, "seconds": 0.1, "rel_mse": null, "low": null, "high": null,
                "half_in_pixels": null, "worst_pixel": null,
            },
            {
                "spp": 64, "seconds": 7.5, "rel_mse": 3.1e-3, "low": 2.76e-3, "high": 3.54e-3,
                "half_in_pixels": null, "worst_pixel": null,
            },
        ],
        "files": ["a.png"],
        "warnings": [],
    });
    assert_eq!(serde_json::to_value(&record).expect("JSON"), expected);
}

#[test]
fn no_time_gives_no_rate() {
    let mut record = record();
    record.work = Work::new(&Seconds::default(), 5, 5, Dropped::default(), 0, 0);
    let value = serde_json::to_value(&record).expect("JSON");
    assert_eq!(
        (&value["samples_per_s"], &value["rays_per_s"]),
        (&Value::Null, &Value::Null)
    );
    assert!(summary(&record).contains("5 samples, 5 rays"));
}

#[test]
fn the_summary_reads_well() {
    let expected = "\
scenes/a.scn: 400×300, 64 samples per pixel, seed 7
  on      llvmpipe, Mesa 22.3.6
  time    read 12 ms, compose 4 ms, pipeline 250 ms, compile 500 ms, render 7.50 s (device 7.25 s), write 20 ms
  work    7.68 M samples (960 k/s), 40.0 M rays (5.00 M/s)
  wrote   a.png
64 spp · 8.00 s (500 ms compile) · 960 k samples/s · relMSE 3.1e-3 (95 %: 2.8–3.5e-3)";
    assert_eq!(summary(&record()), expected);
    assert!(concerns(&record()).is_empty());
}

#[test]
fn the_last_line_prints_the_error_as_well_as_it_is_known() {
    let line = |error: Vec<ErrorAt>| {
        let text = summary(&Record { error, ..record() });
        let line = text.lines().last().unwrap_or_default().to_owned();
        line.rsplit(" · ").next().unwrap_or_default().to_owned()
    };
    let known = |value, low, high| line(vec![at(2, 1.0, Some(value), Some([low, high]))]);
    assert_eq!(
        known(3.1e-3, 3.08e-3, 3.12e-3),
        "relMSE 3.10e-3 (95 %: 3.08–3.12e-3)"
    );
    assert_eq!(
        known(9.97e-4, 8.4e-4, 1.12e-3),
        "relMSE 10.0e-4 (95 %: 8.4–11.2e-4)"
    );
    assert_eq!(known(1.5, 0.9, 2.1), "relMSE 1.5e0 (95 %: 0.9–2.1e0)");
    assert_eq!(known(0.0, 0.0, 0.0), "relMSE 0");
    assert_eq!(line(vec![at(1, 1.0, None, None)]), "relMSE unknown");
    let made_by = |half, worst| {
        line(vec![ErrorAt {
            half_in_pixels: Some(half),
            worst_pixel: Some(worst),
            ..at(2, 1.0, Some(2e-2), None)
        }])
    };
    assert_eq!(
        made_by(3, [12, 40]),
        "relMSE 2.0e-2? (half of it in 3 pixels, the worst 12,40)"
    );
    assert_eq!(
        made_by(1, [0, 7]),
        "relMSE 2.0e-2? (half of it in pixel 0,7)"
    );
    assert_eq!(line(Vec::new()), "960 k samples/s");
}

#[test]
fn a_missed_target_is_printed() {
    let mut record = record();
    record.job.target_error = Some(1e-3);
    assert_eq!(
        concerns(&record),
        ["the error is up to 3.5e-3, not below --target-error 1e-3: --spp ended the rendering"]
    );
    record.job.ended = "time".into();
    record.error.clear();
    assert_eq!(
        concerns(&record),
        ["the error is unknown, not below --target-error 1e-3: --time ended the rendering"]
    );
    record.job.ended = "target-error".into();
    assert!(concerns(&record).is_empty());
}

#[test]
fn concerns_name_causes() {
    let mut record = record();
    record.job.spp = 12;
    record.job.ended = "interrupted".into();
    record.work.dropped = Dropped {
        nan: 3,
        infinite: 1,
        loops: 0,
    };
    record.work.long_paths = 1;
    let expected = [
        "interrupted: the picture is that of --spp 12, not 64",
        "4 of 7680000 samples counted as black: 3 NaN, 1 infinite",
        "1 path exceeded a thousand bounces",
    ];
    assert_eq!(concerns(&record), expected);
    record.work.dropped = Dropped::default();
    record.work.long_paths = 0;
    // With --time no number was requested; and after the last sample none is missing.
    for (spp_asked, expected) in [
        (
            u32::MAX,
            &["interrupted: the picture is that of --spp 12"][..],
        ),
        (12, &[]),
    ] {
        record.job.spp_asked = spp_asked;
        assert_eq!(concerns(&record), expected);
    }
}

#[test]
fn settings_are_printed_in_the_words_of_their_flags() {
    let words = |settings: &Settings| {
        notes(
            &Job {
                settings: settings.into(),
                ..record().job
            },
            "d",
        )[2]
        .1
        .clone()
    };
    assert_eq!(
        words(&Settings::handout()),
        "fresnel=scene distribution=scene absorption=term radiance-scaling=off max-depth=none \
         lobe=norms normals=distribution roulette=0.8 connect=mis lights=power sampler=random"
    );
    let mut settings = Settings::default();
    settings.model.fresnel = Some(Fresnel::Exact);
    settings.model.distribution = DistributionRule::Always(Distribution::Ggx);
    settings.model.max_depth = Some(3);
    settings.estimator.roulette = Roulette::Off;
    settings.estimator.connect = Connect::Light;
    settings.estimator.sampler = Sampler::Random;
    assert_eq!(
        words(&settings),
        "fresnel=exact distribution=ggx absorption=segment radiance-scaling=on max-depth=3 \
         lobe=fresnel normals=visible roulette=off connect=light lights=contribution sampler=random"
    );
}

#[test]
fn a_header_has_everything_that_the_picture_depends_on() {
    let names = |job: &Job| {
        notes(job, "llvmpipe")
            .iter()
            .map(|(name, _)| *name)
            .collect::<Vec<_>>()
    };
    let mut job = record().job;
    assert_eq!(
        names(&job),
        [
            "scene", "size", "settings", "spp", "seed", "device", "version"
        ]
    );
    job.crop = Some([1, 2, 3, 4]);
    let notes = notes(&job, "llvmpipe");
    assert_eq!(notes[2], ("crop", "1,2,3,4".to_owned()));
    assert_eq!(notes[7], ("version", SOFTWARE.to_owned()));
    // An interrupted rendering equals a shorter one, and says the same.
    let asked = Job {
        spp_asked: 12,
        spp: 12,
        ..job.clone()
    };
    let interrupted = Job {
        spp_asked: 64,
        spp: 12,
        ..job
    };
    assert_eq!(
        vkpt::report::notes(&asked, "d"),
        vkpt::report::notes(&interrupted, "d")
    );
}

#[test]
fn only_notes_of_standard_errors_have_degrees_of_freedom() {
    let read = |notes: Vec<(&str, String)>| {
        let lines = notes
            .into_iter()
            .map(|(name, value)| format!("{name}: {value}\n"));
        noted_freedom(&lines.collect::<String>())
    };
    let film = Film {
        width: 1,
        height: 1,
        rgb: vec![[0.5; 3]],
    };
    for freedom in [1.0, 63.0, 4_294_967_294.0] {
        assert_eq!(
            read(stderr_notes(freedom, &film, &record().job, "d")),
            Some(freedom)
        );
    }
    assert_eq!(read(notes(&record().job, "d")), None);
    for foreign in [
        "",
        "degrees of freedom",
        "degrees of freedom: many",
        "degrees of freedom: 0",
        "degrees of freedom: -1",
        "degrees of freedom: NaN",
    ] {
        assert_eq!(noted_freedom(foreign), None, "{foreign}");
    }
}
