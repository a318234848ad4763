//! The choice of a device.

use super::error::GpuError;
use super::info::{DeviceInfo, DeviceKind};

/// Which device to open.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Selector {
    /// The first usable one of the best kind: discrete, integrated, virtual, CPU.
    #[default]
    Best,
    Index(usize),
    /// The first whose name contains this, ignoring case; a usable one before others.
    Name(String),
}

impl From<&str> for Selector {
    /// A number is an index, anything else part of a name.
    fn from(text: &str) -> Self {
        text.parse()
            .map_or_else(|_| Self::Name(text.to_owned()), Self::Index)
    }
}

impl Selector {
    /// Picks from `devices`.
    pub(super) fn pick<'a>(&self, devices: &'a [DeviceInfo]) -> Result<&'a DeviceInfo, GpuError> {
        let named = |d: &&DeviceInfo| match self {
            Self::Best => true,
            Self::Index(i) => d.index == *i,
            Self::Name(name) => d.name.to_lowercase().contains(&name.to_lowercase()),
        };
        let wanted = devices.iter().filter(named).min_by_key(|d| {
            let kind = if *self == Self::Best {
                d.kind
            } else {
                DeviceKind::Discrete
            };
            (d.unusable.is_some(), kind, d.index)
        });
        let device = wanted.ok_or_else(|| self.not_found(devices))?;
        match &device.unusable {
            None => Ok(device),
            Some(reason) => Err(GpuError::Unusable {
                name: device.name.clone(),
                reason: reason.clone(),
            }),
        }
    }

    fn not_found(&self, devices: &[DeviceInfo]) -> GpuError {
        let there: Vec<String> = devices
            .iter()
            .map(|d| format!("{} ({})", d.index, d.name))
            .collect();
        match self {
            Self::Best => GpuError::NoVulkan("the driver reports no device".into()),
            Self::Index(i) => GpuError::NoSuchDevice {
                wanted: i.to_string(),
                there: there.join(", "),
            },
            Self::Name(name) => GpuError::NoSuchDevice {
                wanted: format!("\"{name}\""),
                there: there.join(", "),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn device(index: usize, name: &str, kind: DeviceKind, unusable: Option<&str>) -> DeviceInfo {
        DeviceInfo {
            index,
            name: name.into(),
            kind,
            driver: String::new(),
            vulkan: [1, 1, 0],
            memory: 0,
            unusable: unusable.map(String::from),
        }
    }

    fn pick(selector: &str) -> Result<usize, String> {
        let all = [
            device(0, "llvmpipe", DeviceKind::Cpu, None),
            device(
                1,
                "Old Card",
                DeviceKind::Discrete,
                Some("its driver offers Vulkan 1.0"),
            ),
            device(2, "Small Chip", DeviceKind::Integrated, None),
            device(3, "Large Card", DeviceKind::Discrete, None),
            device(4, "Other Card", DeviceKind::Discrete, None),
        ];
        let selector = if selector.is_empty() {
            Selector::Best
        } else {
            selector.into()
        };
        selector
            .pick(&all)
            .map(|d| d.index)
            .map_err(|e| e.to_string())
    }

    #[test]
    fn the_best_usable_device_is_picked() {
        assert_eq!(pick(""), Ok(3));
        assert_eq!(
            Selector::Best
                .pick(&[])
                .map(|d| d.index)
                .map_err(|e| matches!(e, GpuError::NoVulkan(_))),
            Err(true)
        );
    }

    #[test]
    fn devices_go_by_index_or_part_of_the_name() {
        assert_eq!(pick("2"), Ok(2));
        assert_eq!(pick("CARD"), Ok(3));
        assert_eq!(pick("llvm"), Ok(0));
    }

    #[test]
    fn an_unusable_or_absent_device_is_an_error_with_its_reason() {
        assert_eq!(
            pick("1"),
            Err("Old Card cannot be used: its driver offers Vulkan 1.0".into())
        );
        assert!(pick("9").is_err_and(|e| e.contains("3 (Large Card)")));
    }
}
