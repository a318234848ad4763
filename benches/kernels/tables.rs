//! The runs in tables: medians, and ratios of neighbouring runs.

use super::run::{Kind, Run};

/// All tables, as Markdown.
pub fn tables(runs: &[Run]) -> String {
    let mut scenes: Vec<&str> = runs.iter().map(|r| r.scene.as_str()).collect();
    scenes.dedup();
    let all: Vec<Scene> = scenes.iter().map(|name| Scene { name, runs }).collect();
    [
        table(
            "Rendering, ns a sample; the ratio is the median of those of neighbouring runs, in brackets the least and the greatest",
            &["scene", "composed", "full", "full / composed"],
            &all.iter().map(Scene::speed).collect::<Vec<_>>(),
        ),
        table(
            "Compiling, ms: SPIR-V to the end of the first dispatch",
            &["scene", "bytes of SPIR-V", "full", "share", "cold", "full", "share", "warm", "full", "share"],
            &all.iter().map(Scene::compiling).collect::<Vec<_>>(),
        ),
        table(
            "From the start of the process to its end, one sample a pixel, ms",
            &["scene", "warm", "full", "cold", "full"],
            &all.iter().map(Scene::whole).collect::<Vec<_>>(),
        ),
        table(
            "The host before the first dispatch, warm, ms, composed / full; memory in MiB",
            &["scene", "read", "prepare", "device", "hierarchy", "compose", "upload", "pipeline", "buffers", "peak of the process"],
            &all.iter().map(Scene::host).collect::<Vec<_>>(),
        ),
    ]
    .join("\n")
}

struct Scene<'a> {
    name: &'a str,
    runs: &'a [Run],
}

impl Scene<'_> {
    fn values(&self, kind: Kind, full: bool, value: impl Fn(&Run) -> f64) -> Vec<f64> {
        let mine = |r: &&Run| r.scene == self.name && r.kind == kind && r.full == full;
        self.runs.iter().filter(mine).map(value).collect()
    }

    /// Medians of the composed and the full kernel.
    fn both(&self, kind: Kind, value: impl Fn(&Run) -> f64) -> [f64; 2] {
        [false, true].map(|full| median(self.values(kind, full, &value)))
    }

    fn speed(&self) -> Vec<String> {
        let ns = |r: &Run| 1e9 * r.number("/seconds/gpu") / r.number("/samples");
        let [composed, full] = self.both(Kind::Render, ns);
        let pairs = self.values(Kind::Render, true, ns).into_iter();
        let mut ratios: Vec<f64> = pairs
            .zip(self.values(Kind::Render, false, ns))
            .map(|(full, composed)| full / composed)
            .collect();
        ratios.sort_by(f64::total_cmp);
        let [least, most] = [ratios.first(), ratios.last()].map(|r| r.copied().unwrap_or(f64::NAN));
        let ratio = format!("{:.2} ({least:.2} to {most:.2})", median(ratios));
        row(
            self.name,
            [format!("{composed:.0}"), format!("{full:.0}"), ratio],
        )
    }

    fn compiling(&self) -> Vec<String> {
        let bytes = self.both(Kind::Warm, |r| r.number("/kernel/spirv_bytes"));
        let ms = |r: &Run| 1e3 * (r.number("/seconds/pipeline") + r.number("/seconds/compile"));
        let (cold, warm) = (self.both(Kind::Cold, ms), self.both(Kind::Warm, ms));
        let cells = [bytes, cold, warm].into_iter().flat_map(|[a, b]| {
            [
                format!("{a:.0}"),
                format!("{b:.0}"),
                format!("{:.2}", a / b),
            ]
        });
        row(self.name, cells)
    }

    fn whole(&self) -> Vec<String> {
        let ms = |r: &Run| 1e3 * r.number("/whole");
        let times = [Kind::Warm, Kind::Cold].map(|kind| self.both(kind, ms));
        row(
            self.name,
            times.into_iter().flatten().map(|t| format!("{t:.0}")),
        )
    }

    fn host(&self) -> Vec<String> {
        let stages = [
            "read",
            "prepare",
            "device",
            "hierarchy",
            "compose",
            "upload",
            "pipeline",
        ];
        let times = stages.map(|stage| {
            let path = format!("/seconds/{stage}");
            let [a, b] = self.both(Kind::Warm, |r| 1e3 * r.number(&path));
            format!("{a:.1} / {b:.1}")
        });
        let memory = ["/memory/device", "/memory/peak"].map(|path| {
            let [a, b] = self.both(Kind::Warm, |r| r.number(path) / f64::from(1 << 20));
            format!("{a:.1} / {b:.1}")
        });
        row(self.name, times.into_iter().chain(memory))
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => values[n / 2],
        n => (values[n / 2 - 1] + values[n / 2]) / 2.0,
    }
}

fn row(name: &str, cells: impl IntoIterator<Item = String>) -> Vec<String> {
    std::iter::once(name.to_owned()).chain(cells).collect()
}

fn table(title: &str, head: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = format!("## {title}\n\n");
    text += &line(head.iter().map(|h| (*h).to_owned()).collect());
    text += &line(head.iter().map(|_| "---".to_owned()).collect());
    text.extend(rows.iter().map(|cells| line(cells.clone())));
    text
}
