//! Devices, buffers and dispatches, under the validation layer.

use std::process::Command;
use std::time::Duration;

use vkpt::gpu::{BufferUse, Device, DeviceKind, GpuError, Options, Pipeline, Selector, devices};
use vkpt::kernel::{Composer, Spirv, compile};

use crate::common;
use crate::common::needs::Need;

/// x ← k·x + y for each x of a storage buffer, y from a uniform buffer, k a push constant.
const SCALE: &str = "layout(local_size_x = 64) in;
layout(std140, set = 0, binding = 0) uniform Parameters { uint y; uint count; } parameters;
layout(std430, set = 0, binding = 1) buffer Numbers { uint x[]; } numbers;
layout(push_constant) uniform Push { uint k; } push;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < parameters.count) {
        numbers.x[i] = push.k * numbers.x[i] + parameters.y;
    }
}
";
const USES: [BufferUse; 2] = [BufferUse::Uniform, BufferUse::Storage];

fn kernel(text: &str) -> Spirv {
    let composed = Composer::new().add("root", text).compose(&["root"]);
    composed.and_then(|k| compile(&k)).expect("a valid kernel")
}

fn scale(device: &Device) -> Pipeline {
    device
        .pipeline(&kernel(SCALE), &USES, 4)
        .expect("a pipeline")
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytemuck::pod_collect_to_vec(bytes)
}

/// Fails with the messages of the validation layer.
fn assert_valid(device: &Device) {
    let messages = device.validation_messages();
    assert!(
        messages.is_empty(),
        "the validation layer says: {}",
        messages.join("\n")
    );
}

// ---- devices

#[test]
fn devices_are_listed_with_their_drivers() {
    if common::device().is_none() {
        return;
    }
    let all = devices().expect("devices");
    for (i, device) in all.iter().enumerate() {
        assert_eq!(device.index, i);
        assert!(
            !device.name.is_empty() && !device.driver.is_empty(),
            "{device:?}"
        );
        assert!(device.memory > 0, "{device:?}");
        if device.kind == DeviceKind::Cpu && device.name.contains("llvmpipe") {
            assert!(device.driver.contains("Mesa "), "{device:?}");
        }
    }
}

#[test]
fn a_missing_device_is_named_with_the_available_ones() {
    let Some(device) = common::device() else {
        return;
    };
    for selector in ["no such GPU", "4711"] {
        let error = Device::open(&Selector::from(selector))
            .err()
            .expect("an error")
            .to_string();
        assert!(
            error.contains(selector) && error.contains(&device.info().name),
            "{error}"
        );
    }
}

#[test]
fn devices_open_by_part_of_their_name() {
    let Some(device) = common::device() else {
        return;
    };
    let part = device.info().name[..4].to_uppercase();
    let again = Device::open(&Selector::from(part.as_str())).expect("the same device");
    assert_eq!(again.info().name, device.info().name);
}

/// Run by the test below in a process whose loader has no driver.
#[test]
#[ignore = "only of use to a_missing_driver_is_named_with_the_package_to_install"]
fn child_without_a_driver() {
    println!("{}", devices().expect_err("no driver"));
    println!(
        "{}",
        Device::open(&Selector::Best).err().expect("no driver")
    );
}

#[test]
fn a_missing_driver_is_named_with_the_package_to_install() {
    let child = Command::new(std::env::current_exe().expect("a path"))
        .args([
            "--exact",
            "gpu::child_without_a_driver",
            "--ignored",
            "--nocapture",
        ])
        .env("VK_DRIVER_FILES", "/nonexistent")
        .env("VK_ICD_FILENAMES", "/nonexistent")
        .output()
        .expect("runs");
    let text = String::from_utf8_lossy(&child.stdout);
    assert!(child.status.success(), "{text}");
    assert_eq!(text.matches("no Vulkan device").count(), 2, "{text}");
    assert!(
        text.contains("mesa-vulkan-drivers") && text.contains("--device cpu-f64"),
        "{text}"
    );
}

// ---- buffers

/// Direct and staged; more than one piece is staged, and the last byte is no multiple of four.
#[test]
fn written_values_are_read_back() {
    for always_stage in [false, true] {
        let Some(device) = common::open(Options {
            always_stage,
            ..Options::default()
        }) else {
            return;
        };
        let bytes: Vec<u8> = (0..40_000_001u32)
            .map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8)
            .collect();
        let buffer = device
            .buffer("bytes", BufferUse::Storage, bytes.len() as u64)
            .expect("a buffer");
        assert!(buffer.read().expect("zeros").iter().all(|b| *b == 0));
        buffer.write(&bytes).expect("written");
        assert!(buffer.read().expect("read") == bytes);
        let mut first = [0; 3];
        buffer.read_into(&mut first).expect("read");
        assert_eq!(first, bytes[..3]);
        buffer.clear().expect("cleared");
        assert!(buffer.read().expect("zeros").iter().all(|b| *b == 0));
        assert_valid(&device);
    }
}

#[test]
fn too_many_bytes_for_a_buffer_are_refused() {
    let Some(device) = common::device() else {
        return;
    };
    let buffer = device
        .buffer("seeds", BufferUse::Storage, 8)
        .expect("a buffer");
    let error = buffer.write(&[0; 9]).expect_err("too long");
    assert_eq!(error.to_string(), "seeds has 8 bytes, but 9 were given");
    assert!(buffer.read_into(&mut [0; 9]).is_err());
}

#[test]
fn a_buffer_of_no_bytes_is_a_buffer() {
    let Some(device) = common::device() else {
        return;
    };
    let empty = device
        .buffer("no lights", BufferUse::Uniform, 0)
        .expect("a buffer");
    assert_eq!((empty.bytes(), empty.read().expect("read")), (0, vec![]));
    empty.write(&[]).expect("written");
    assert_valid(device);
}

#[test]
fn buffers_above_the_limits_are_refused_by_name_and_size() {
    let Some(device) = common::device() else {
        return;
    };
    let limits = *device.limits();
    for (usage, limit) in [
        (BufferUse::Storage, limits.storage_buffer),
        (BufferUse::Uniform, limits.uniform_buffer),
    ] {
        match device.buffer("triangles", usage, limit + 1).err() {
            Some(GpuError::TooLarge {
                name,
                bytes,
                limit: found,
                ..
            }) => {
                assert_eq!(
                    (name.as_str(), bytes, found),
                    ("triangles", limit + 1, limit)
                );
            }
            other => panic!("{usage:?}: {other:?}"),
        }
    }
    device
        .buffer("parameters", BufferUse::Uniform, limits.uniform_buffer)
        .expect("just within the limit");
    assert_valid(device);
}

// ---- dispatches

#[test]
fn dispatches_see_the_writes_before_them() {
    for always_stage in [false, true] {
        let Some(device) = common::open(Options {
            always_stage,
            ..Options::default()
        }) else {
            return;
        };
        let pipeline = scale(&device);
        let parameters = device
            .buffer("parameters", BufferUse::Uniform, 8)
            .expect("a buffer");
        let numbers = device
            .buffer("numbers", BufferUse::Storage, 4000)
            .expect("a buffer");
        let start: Vec<u32> = (0..1000).collect();
        numbers
            .write(bytemuck::cast_slice(&start))
            .expect("written");
        let mut expected = start;
        for k in 2..6u32 {
            parameters
                .write(bytemuck::cast_slice(&[k * k, 999]))
                .expect("written");
            let time = device.dispatch(
                &pipeline,
                &[&parameters, &numbers],
                &k.to_le_bytes(),
                [16, 1, 1],
            );
            let time = time.expect("dispatched");
            assert!(
                time > Duration::ZERO && time < Duration::from_secs(10),
                "{time:?}"
            );
            expected[..999].iter_mut().for_each(|x| *x = k * *x + k * k);
        }
        assert_eq!(words(&numbers.read().expect("read")), expected);
        assert_valid(&device);
    }
}

#[test]
fn threads_share_a_device() {
    let Some(device) = common::device() else {
        return;
    };
    std::thread::scope(|scope| {
        for y in 0..4u32 {
            scope.spawn(move || {
                let pipeline = scale(device);
                let parameters = device
                    .buffer("parameters", BufferUse::Uniform, 8)
                    .expect("a buffer");
                let numbers = device
                    .buffer("numbers", BufferUse::Storage, 4)
                    .expect("a buffer");
                parameters
                    .write(bytemuck::cast_slice(&[y, 1]))
                    .expect("written");
                for _ in 0..20 {
                    let buffers = [&parameters, &numbers];
                    device
                        .dispatch(&pipeline, &buffers, &1u32.to_le_bytes(), [1, 1, 1])
                        .expect("dispatched");
                }
                assert_eq!(words(&numbers.read().expect("read")), [20 * y]);
            });
        }
    });
    assert_valid(device);
}

#[test]
fn a_dispatch_that_does_not_fit_its_kernel_is_refused() {
    let Some(device) = common::device() else {
        return;
    };
    let pipeline = scale(device);
    let parameters = device
        .buffer("parameters", BufferUse::Uniform, 8)
        .expect("a buffer");
    let numbers = device
        .buffer("numbers", BufferUse::Storage, 4)
        .expect("a buffer");
    let refused = |buffers: &[_], push: &[u8], groups| match device
        .dispatch(&pipeline, buffers, push, groups)
    {
        Err(GpuError::Mismatch(message)) => message,
        other => panic!("{other:?}"),
    };
    assert!(refused(&[&numbers, &parameters], &[0; 4], [1; 3]).contains("buffers"));
    assert!(refused(&[&parameters], &[0; 4], [1; 3]).contains("buffers"));
    assert!(refused(&[&parameters, &numbers], &[0; 8], [1; 3]).contains("push constants"));
    let x = device.limits().group_count[0];
    if x < u32::MAX {
        assert!(refused(&[&parameters, &numbers], &[0; 4], [x + 1, 1, 1]).contains("workgroups"));
    }
    assert_valid(device);
}

#[test]
fn a_kernel_beyond_the_limits_is_refused() {
    let Some(device) = common::device() else {
        return;
    };
    let size = device.limits().group_invocations + 1;
    let large = kernel(&SCALE.replace("local_size_x = 64", &format!("local_size_x = {size}")));
    let error = device
        .pipeline(&large, &USES, 4)
        .err()
        .expect("too large")
        .to_string();
    assert!(error.contains(&format!("{size} invocations")), "{error}");
    let push = device.limits().push_constants + 4;
    assert!(matches!(
        device.pipeline(&kernel(SCALE), &USES, push).err(),
        Some(GpuError::Mismatch(_))
    ));
}

/// The layer's messages do arrive: the kernel has push constants, the pipeline is made without.
#[test]
fn the_validation_layer_is_heard() {
    let Some(device) = common::open(Options::default()) else {
        return;
    };
    if Need::Validation.skips() {
        return;
    }
    assert_valid(&device);
    let _ = device.pipeline(&kernel(SCALE), &USES, 0);
    let messages = device.validation_messages();
    assert!(messages.iter().any(|m| m.contains("VUID")), "{messages:?}");
}

#[test]
fn a_kernel_that_takes_too_long_is_given_up() {
    let patience = Duration::from_millis(1);
    let Some(fast) = common::device() else { return };
    let Some(device) = common::open(Options {
        patience,
        ..Options::default()
    }) else {
        return;
    };
    let busy = kernel(
        "layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) buffer Words { uint w[]; } words;
void main() {
    uint state = words.w[0];
    uint i = 0u;
    while (i < 50000u) {
        state = (state ^ (state >> 15)) * 1664525u + 1013904223u;
        i += 1u;
    }
    words.w[gl_GlobalInvocationID.x & 63u] = state;
}
",
    );
    let run = |device: &Device, groups: u32| {
        let pipeline = device.pipeline(&busy, &[BufferUse::Storage], 0)?;
        let words = device.buffer("words", BufferUse::Storage, 256)?;
        let time = device.dispatch(&pipeline, &[&words], &[], [groups, 1, 1])?;
        let again = words.read();
        again.map(|_| time)
    };
    // As many groups as take the device long enough, however fast it is.
    let (mut groups, mut needs) = (100, Duration::ZERO);
    while needs < 4 * patience {
        assert!(groups <= fast.limits().group_count[0], "{needs:?} only");
        needs = run(fast, groups).expect("runs");
        groups *= 4;
    }
    assert!(matches!(
        run(&device, groups / 4),
        Err(GpuError::TimeOut(_))
    ));
    assert!(matches!(
        device.buffer("more", BufferUse::Storage, 4).err(),
        Some(GpuError::Lost)
    ));
    // Another device of the same process is none the worse for it.
    if let Some(another) = common::open(Options::default()) {
        run(&another, 1).expect("runs");
    }
    // The driver's threads are still at work: let them finish before the process ends.
    std::thread::sleep(10 * needs);
}

/// Mesa's lavapipe up to 22 ends loops after 65,535 steps; other drivers are not known to.
#[test]
fn the_loop_limit_is_found() {
    let Some(device) = common::device() else {
        return;
    };
    let limit = device.loop_limit().expect("probed");
    if device.info().driver.contains("Mesa 22") && device.info().kind == DeviceKind::Cpu {
        assert_eq!(limit, Some(65_535));
    } else {
        println!("{}: loop limit {limit:?}", device.info().driver);
    }
    assert_eq!(device.loop_limit().expect("remembered"), limit);
    assert_valid(device);
}
