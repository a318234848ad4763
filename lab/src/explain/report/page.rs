//! The page that `vkpt explain` prints.

use super::{Buffer, Count, Explanation, KernelSize, Memory, Part};
use crate::table::{columns, hanging, once};
use vkpt::report::human::{bytes, plural, thousands};

/// The whole page, at most 100 characters per line.
pub fn page(e: &Explanation) -> String {
    let (present, absent): (Vec<&Part>, Vec<&Part>) = e.parts.iter().partition(|p| p.present);
    let counts = e
        .counts
        .as_ref()
        .map(|c| section(&format!("Driver statistics of {}", e.device), &counts(c)));
    let sections = [
        head(e),
        section(
            "In the kernel, needed by these lines of the scene (the first is quoted) or selected by flags",
            &parts(&present),
        ),
        section("Not in the kernel, and why", &parts(&absent)),
        section(
            "Size, compared with the full kernel, which has every part",
            &sizes(&e.kernels),
        ),
        section("Search for the nearest hit", &search(e)),
        section("Buffers on the device", &buffers(&e.buffers)),
        section("Expected memory", &memory(&e.memory)),
    ];
    let sections: Vec<String> = sections.into_iter().chain(counts).collect();
    sections.join("\n")
}

fn head(e: &Explanation) -> String {
    let [width, height] = e.size;
    let crop = e.crop.map_or(String::new(), |[x0, y0, x1, y1]| {
        format!(", crop {x0},{y0},{x1},{y1}")
    });
    format!(
        "{}: {width}×{height} pixels{crop}; limits: {}\n",
        e.scene, e.device
    )
}

fn section(title: &str, text: &str) -> String {
    format!("{title}\n{text}")
}

/// Parts selected by flags and defaults show the reason in place of lines.
fn parts(parts: &[&Part]) -> String {
    let groups: Vec<&str> = parts.iter().map(|p| p.group).collect();
    let width = |cell: &dyn Fn(&Part) -> usize| parts.iter().map(|p| cell(p)).max().unwrap_or(0);
    let group = width(&|p| p.group.chars().count());
    let name = width(&|p| p.name.chars().count());
    let line = width(&|p| lines(&p.lines).chars().count());
    let row = |(i, part): (usize, &&Part)| {
        let mut before = format!("  {:<group$}  {:<name$}  ", once(&groups, i), part.name);
        if part.present && !part.lines.is_empty() {
            before += &format!("{:<line$}  ", lines(&part.lines));
        }
        hanging(
            &before,
            if part.why.is_empty() {
                &part.quote
            } else {
                &part.why
            },
        )
    };
    parts.iter().enumerate().map(row).collect()
}

/// `12`, `12, 18`, `12, 18 and 3 more`.
fn lines(lines: &[usize]) -> String {
    match lines {
        [] => String::new(),
        [one] => one.to_string(),
        [a, b] => format!("{a}, {b}"),
        [a, b, rest @ ..] => format!("{a}, {b} and {} more", rest.len()),
    }
}

fn sizes([this, full]: &[KernelSize; 2]) -> String {
    let row = |name: &str, size: &dyn Fn(&KernelSize) -> usize| {
        let (a, b) = (size(this), size(full));
        let share = format!("{:.0} %", 100.0 * a as f64 / b.max(1) as f64);
        [
            name.to_owned(),
            thousands(a as u64),
            thousands(b as u64),
            share,
        ]
    };
    let head = ["", "this", "full", ""].map(str::to_owned);
    let rows = [
        head,
        row("files of GLSL", &|k| k.files),
        row("lines of GLSL", &|k| k.lines),
        row("functions", &|k| k.functions),
        row("bytes of SPIR-V", &|k| k.spirv_bytes),
        row("instructions", &|k| k.instructions),
    ];
    columns(&rows, [false, true, true, true])
}

fn counts(counts: &[Count]) -> String {
    if counts.is_empty() {
        return "  none: the driver lacks VK_KHR_pipeline_executable_properties\n".to_owned();
    }
    let row = |i: usize| {
        let Count {
            kernel,
            executable,
            name,
            value,
        } = &counts[i];
        let first = i == 0
            || [kernel, executable.as_str()] != [counts[i - 1].kernel, &counts[i - 1].executable];
        let of = format!("{kernel} {executable}").trim().to_owned();
        [
            if first { of } else { String::new() },
            name.clone(),
            value.clone(),
        ]
    };
    let rows: Vec<_> = (0..counts.len()).map(row).collect();
    columns(&rows, [false, false, true])
}

fn search(e: &Explanation) -> String {
    let Some(h) = &e.hierarchy else {
        let all = count(e.primitives, "primitive");
        return format!("  no hierarchy: a ray is tested against all of {all}\n");
    };
    let text = [
        format!(
            "compressed wide BVH (CWBVH, built by obvhs): eight children and {} bytes per node",
            h.node_bytes
        ),
        format!(
            "{}, {}, a traversal stack of {}",
            count(h.nodes, "node"),
            count(h.primitives, "primitive"),
            count(h.stack as usize, "level")
        ),
        format!(
            "cost by the surface area heuristic: a line through the scene's box meets {:.1} nodes",
            h.node_visits
        ),
        format!(
            "and is tested against {:.1} primitives, on average over all such lines",
            h.primitive_tests
        ),
    ];
    let mut text = text.map(|line| format!("  {line}\n")).concat();
    if e.primitives > h.primitives {
        let others = count(e.primitives - h.primitives, "primitive");
        text += &format!("  not in it, tested one by one: {others}\n");
    }
    text
}

fn count(n: usize, noun: &str) -> String {
    plural(n as u64, noun).replacen(&n.to_string(), &thousands(n as u64), 1)
}

fn buffers(buffers: &[Buffer]) -> String {
    let kind = |b: &Buffer| match (b.uniform, b.written) {
        (true, _) => "uniform",
        (false, false) => "storage, read",
        (false, true) => "storage, read and written, for one tile",
    };
    let mut rows = vec![["name", "elements", "of", "bytes", "use"].map(str::to_owned)];
    rows.extend(buffers.iter().map(|b| {
        let (count, bytes) = (thousands(b.count as u64), thousands(b.bytes));
        [
            b.name.into(),
            count,
            b.element.into(),
            bytes,
            kind(b).into(),
        ]
    }));
    columns(&rows, [false, true, false, true, false])
}

fn memory(m: &Memory) -> String {
    let pixels = thousands(m.tile_pixels.into());
    let tiles = match m.tiles {
        1 => format!("one tile of {pixels} pixels"),
        n => format!("{n} tiles of up to {pixels} pixels, one after the other"),
    };
    let host = m.scene + m.films + m.pictures;
    let mut rows = vec![
        [
            "on the device".to_owned(),
            bytes(m.device),
            format!("all buffers; {tiles}"),
        ],
        [
            "on the host".to_owned(),
            bytes(host),
            format!(
                "scene in f64 {}, films of all tiles {}, pictures {}",
                bytes(m.scene),
                bytes(m.films),
                bytes(m.pictures)
            ),
        ],
    ];
    if m.peak > host {
        let when = "approximately, while the scene is prepared".to_owned();
        rows.push(["at most".to_owned(), bytes(m.peak), when]);
    }
    columns(&rows, [false, true, false])
}
