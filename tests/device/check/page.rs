//! The page as a text: self-contained, every case with its bounds and pictures, failures first. Its look and behaviour
//! are tested in `tests/commands/report_page`.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use vkpt::metrics::{difference_colour, difference_map};
use vkpt_lab::check::report::{Check, Held, Sheet, Shown, page};

use crate::common::checks::{PLANTED, case, check, run, shown};
use crate::common::pages::{MARKUP, no_markup, outside};

fn written(record: &Check, shown: &[Shown]) -> String {
    let sheet = Sheet {
        record,
        command: "vkpt check --html r.html".to_owned(),
        shown,
    };
    page(&sheet).expect("a page")
}

/// The two cases of [`run`] with a picture each.
fn both() -> String {
    written(&run(), &[shown(), shown()])
}

/// The pictures of a page, as their sRGB codes, with their widths.
fn pictures(page: &str) -> Vec<(u32, Vec<[u8; 3]>)> {
    let before = "src=\"data:image/png;base64,";
    let texts = page.split(before).skip(1);
    let decode = |rest: &str| {
        let text = rest.split('"').next().expect("an end");
        let png = STANDARD.decode(text).expect("base64");
        let film = vkpt::image::decode(&png).expect("a PNG").film;
        let code = |x: f32| vkpt::image::srgb::quantise(x.into());
        (film.width, film.rgb.iter().map(|p| p.map(code)).collect())
    };
    texts.map(decode).collect()
}

#[test]
fn it_is_whole_by_itself() {
    assert_eq!(outside(&both()), Vec::<&str>::new());
    assert!(both().contains("default-src &#39;none&#39;") || both().contains("default-src 'none'"));
    assert!(!both().contains("<script"));
    assert_eq!(both(), both());
}

#[test]
fn every_case_is_there_with_its_bounds_and_pictures() {
    let page = both();
    for case in run().cases {
        assert!(page.contains(&format!("<tr id=\"{}\"", case.name)));
        assert!(
            page.contains(&format!("vkpt check --case &#39;{}&#39;", case.name))
                || page.contains(&format!("vkpt check --case '{}'", case.name))
        );
        for held in &case.held {
            assert!(page.contains(&held.why), "{}", held.why);
        }
    }
    for words in [
        "Stiff cases on a device",
        "its driver",
        "1 of 2 cases fails.",
        "1,048,576",
        "1.2e-7",
        "0.12 %",
        "pixel 1,2, sample 3",
        "screen 16 16\ncamera",
        "sampler=",
        "<span class=\"word\">--html</span>",
    ] {
        assert!(page.contains(words), "{words}");
    }
    assert_eq!(pictures(&page).len(), 2 * 3);
}

/// Without pictures too, as where there are none.
#[test]
fn failures_come_first_and_are_open() {
    for page in [both(), written(&run(), &[])] {
        let (findings, groups) = page.split_once("<section id=\"group-").expect("groups");
        assert!(findings.contains("Failures"));
        assert!(findings.contains("href=\"#furnace/rough-cylinder/2^-17\""));
        assert!(findings.contains("× 4.50") && findings.contains("× ∞"));
        assert!(!findings.contains("alpha/ggx/1e-3"));
        assert_eq!(groups.matches("<details open>").count(), 1);
        assert!(groups.contains("∞ fails"));
    }
    let sound = check(vec![case("a/b", vec![Held::new("weight", 0.5, 1.0, "")])]);
    let page = written(&sound, &[shown()]);
    assert!(page.contains("The only case is within its bounds.") && !page.contains("Failures"));
    assert!(!page.contains("<details open>"));
}

#[test]
fn a_run_that_was_cut_short_says_so() {
    let mut record = check(Vec::new());
    (record.interrupted, record.quick) = (true, true);
    let page = written(&record, &[]);
    for words in ["No case ran.", "Interrupted", "A quick run"] {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn words_are_no_markup() {
    let with = |words: &str| {
        let mut bad = case(
            &format!("a/{words}"),
            vec![Held::new("weight", 2.0, 1.0, words)],
        );
        bad.about = words.to_owned();
        bad.warnings = vec![words.to_owned()];
        let mut record = check(vec![bad]);
        (record.device, record.driver) = (words.to_owned(), words.to_owned());
        let shown = Shown {
            scene: words.to_owned(),
            ..shown()
        };
        written(&record, &[shown])
    };
    let (page, plain) = (with(MARKUP), with("plain"));
    no_markup(&page, &plain);
}

#[test]
fn a_planted_difference_is_seen_in_its_pixel_alone() {
    let pictures = pictures(&both());
    let (width, codes) = &pictures[2];
    let ([x, y], difference) = PLANTED;
    for (k, code) in codes.iter().enumerate() {
        let place = [k % *width as usize, k / *width as usize];
        let expected = if place == [x, y] { difference } else { 0.0 };
        assert_eq!(*code, difference_colour(expected), "{place:?}");
    }
    // The device's picture and the reference's are the same here.
    assert_eq!(pictures[0], pictures[1]);
    assert_ne!(pictures[0], pictures[2]);
}

/// Brightened by whole stops, both sides alike, by the reference's mean.
#[test]
fn pictures_are_brightened_alike() {
    let mut dim = shown();
    for film in [&mut dim.device, &mut dim.reference] {
        film.rgb = vec![[2f32.powi(-20); 3]; 256];
    }
    dim.device.rgb[7] = [2f32.powi(-21); 3];
    let page = written(&run(), &[dim, shown()]);
    let pictures = pictures(&page);
    let code = vkpt::image::srgb::quantise;
    assert_eq!(pictures[1].1, [[code(0.25); 3]; 256]);
    assert_eq!(pictures[0].1[7], [code(0.125); 3]);
    assert_eq!(pictures[0].1[8], [code(0.25); 3]);
    assert!(page.contains("+18 stops"));
    let black = Shown {
        difference: difference_map(16, 16, &[f64::NAN; 256]),
        ..shown()
    };
    let drawn = self::pictures(&written(&run(), &[black]));
    assert_eq!(drawn[2].1, [[0; 3]; 256]);
}

/// A battery has scenes of ten thousand lights.
#[test]
fn a_long_scene_is_cut() {
    let long = Shown {
        scene: "sphere 0 0 0 1\n".repeat(10_000),
        triangles: Some(7),
        ..shown()
    };
    let page = written(&run(), &[long, shown()]);
    assert!(
        page.contains("the first 40 of 10,000 lines") && page.contains("a mesh of 7 triangles")
    );
    assert_eq!(page.matches("sphere 0 0 0 1").count(), 40);
}

/// Pictures are the page's alone.
#[test]
fn the_json_has_no_pictures() {
    let json = serde_json::to_string(&run()).expect("JSON");
    for word in ["rgb", "screen 16", "base64", "settings"] {
        assert!(!json.contains(word), "{word}");
    }
}
