//! `vkpt devices`: lists the devices, and why some cannot render.

use vkpt::gpu::{self, DeviceInfo, GpuError};
use vkpt_lab::cli::destination::all_written;
use vkpt_lab::cli::exit::{Ending, Failure};
use vkpt_lab::cli::streams::put;

/// Prints a table on stdout: the value for `--device`, then the device. The reference renderer is always available.
pub fn devices() -> Result<Ending, Failure> {
    let (vulkan, failure) = match gpu::devices() {
        Ok(vulkan) => (vulkan, None),
        Err(error) => (Vec::new(), Some(error)),
    };
    all_written([put(table(&rows(&vulkan)).as_bytes())])?;
    let usable = vulkan.iter().any(|device| device.unusable.is_none());
    match failure {
        None if usable => Ok(Ending::Complete),
        None => Err(Failure::NoDevice(
            "none of these Vulkan devices can be used".to_owned(),
        )),
        Some(error @ GpuError::NoVulkan(_)) => Err(Failure::NoDevice(error.to_string())),
        Some(error) => Err(Failure::Render(error.into())),
    }
}

type Row = [String; 6];

fn rows(vulkan: &[DeviceInfo]) -> Vec<Row> {
    let head = ["DEVICE", "NAME", "KIND", "DRIVER", "MEMORY", "USABLE"].map(str::to_owned);
    let reference =
        |device: &str, name: &str| [device, name, "cpu", "none", "", "yes"].map(str::to_owned);
    let mut rows = vec![head];
    rows.extend(vulkan.iter().map(row));
    rows.push(reference(
        "cpu-f32",
        "vkpt's reference renderer, single precision",
    ));
    rows.push(reference(
        "cpu-f64",
        "vkpt's reference renderer, double precision",
    ));
    rows
}

fn row(device: &DeviceInfo) -> Row {
    let [major, minor, patch] = device.vulkan;
    let gibibytes = device.memory as f64 / f64::from(1u32 << 30);
    [
        device.index.to_string(),
        device.name.clone(),
        device.kind.to_string(),
        format!("{}, Vulkan {major}.{minor}.{patch}", device.driver),
        format!("{gibibytes:.1} GiB"),
        device
            .unusable
            .as_ref()
            .map_or("yes".to_owned(), |reason| format!("no: {reason}")),
    ]
}

/// Columns as wide as their widest cell, two blanks between them.
fn table(rows: &[Row]) -> String {
    let width = |column: usize| {
        rows.iter()
            .map(|row| row[column].chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: [usize; 6] = std::array::from_fn(width);
    let line = |row: &Row| {
        let cells: Vec<String> = row
            .iter()
            .zip(widths)
            .map(|(cell, width)| format!("{cell:<width$}"))
            .collect();
        format!("{}\n", cells.join("  ").trim_end())
    };
    rows.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use vkpt::gpu::DeviceKind;

    #[test]
    fn columns_line_up_and_reasons_are_printed() {
        let device = |index, name: &str, unusable: Option<&str>| DeviceInfo {
            index,
            name: name.to_owned(),
            kind: DeviceKind::Discrete,
            driver: "d 1".to_owned(),
            vulkan: [1, 3, 2],
            memory: 3 << 29,
            unusable: unusable.map(str::to_owned),
        };
        let table = table(&rows(&[
            device(0, "A", None),
            device(1, "Bé", Some("no f64")),
        ]));
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines.len(), 5);
        let column = |line: &str, cell: &str| line.find(cell).map(|at| line[..at].chars().count());
        assert_eq!(column(lines[1], "discrete"), column(lines[2], "discrete"));
        assert!(
            lines[1].ends_with("discrete  d 1, Vulkan 1.3.2  1.5 GiB  yes"),
            "{table}"
        );
        assert!(lines[2].ends_with("1.5 GiB  no: no f64"), "{table}");
        assert!(lines[3].starts_with("cpu-f32") && lines[4].starts_with("cpu-f64"));
    }
}
