//! Devices that fail: if any Vulkan call fails, in any way, a rendering ends as documented, and no output is half written.
//!
//! `layer.c` makes calls fail. The tests here try calls from the first to the last; `cargo test --test commands -- --ignored
//! every_call` tries all.

mod expected;
mod layer;
mod planted;
mod trial;

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use layer::Layer;
use trial::{Left, Trial, rendering};

/// The errors that any call may return, as Vulkan numbers them: the host's memory, the device's, and an unknown error.
const ANYWHERE: [i32; 3] = [-1, -2, -13];

/// Other errors (Vulkan 1.3, "Return Codes" of each command).
fn errors(call: &str) -> Vec<i32> {
    let own: &[i32] = match call {
        // VK_ERROR_INITIALIZATION_FAILED, VK_ERROR_INCOMPATIBLE_DRIVER
        "vkCreateInstance" => &[-3, -9],
        "vkEnumeratePhysicalDevices" => &[-3],
        // VK_ERROR_DEVICE_LOST, VK_ERROR_TOO_MANY_OBJECTS
        "vkCreateDevice" => &[-3, -4, -10],
        "vkAllocateMemory" => &[-10],
        // VK_ERROR_MEMORY_MAP_FAILED
        "vkMapMemory" => &[-5],
        // VK_ERROR_FRAGMENTED_POOL, VK_ERROR_OUT_OF_POOL_MEMORY
        "vkAllocateDescriptorSets" => &[-12, -1_000_069_000],
        // VK_ERROR_INVALID_SHADER_NV
        "vkCreateShaderModule" | "vkCreateComputePipelines" => &[-1_000_012_000],
        "vkQueueSubmit" => &[-4],
        // VK_TIMEOUT
        "vkWaitForFences" => &[-4, 2],
        // VK_NOT_READY
        "vkGetQueryPoolResults" => &[-4, 1],
        _ => &[],
    };
    [&ANYWHERE, own].concat()
}

/// The first, some on the way, the last.
fn some(calls: usize) -> Vec<usize> {
    let mut some = vec![1, 2, 3, calls / 2, calls];
    some.retain(|n| (1..=calls).contains(n));
    some.sort_unstable();
    some.dedup();
    some
}

/// Every entry point that vkpt calls fails in every way at the calls that `picked` picks of their number.
fn sweep(picked: fn(usize) -> Vec<usize>) {
    let Some(layer) = Layer::built() else { return };
    let (sound, counts) = sound(&layer);
    let faults = counts.iter().flat_map(|(call, calls)| {
        let numbered = move |n: usize| errors(call).into_iter().map(move |error| (n, error));
        let fault = move |(n, error)| format!("{call}:{n}:{error}");
        picked(*calls).into_iter().flat_map(numbered).map(fault)
    });
    all_as_expected(&layer, &sound, &faults.collect::<Vec<_>>());
}

/// A rendering without faults, and how often it calls each entry point.
fn sound(layer: &Layer) -> (Trial, BTreeMap<String, usize>) {
    let (sound, counts) = layer.count();
    assert_eq!(sound.code, Some(0), "{}", sound.err);
    assert_eq!(counts.len(), layer::CALLS);
    let idle: Vec<_> = counts.iter().filter(|(_, calls)| **calls == 0).collect();
    assert!(idle.is_empty(), "never called: {idle:?}");
    (sound, counts)
}

/// Two at a time; everything unexpected is reported.
fn all_as_expected(layer: &Layer, sound: &Trial, faults: &[String]) {
    let (next, wrong) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some(fault) = faults.get(next.fetch_add(1, Ordering::Relaxed)) {
            let trial = rendering(layer, fault);
            if let Err(why) = expected::check(fault, &trial, sound) {
                let message = format!("VKPT_FAULT={fault}: {why}\n{trial}");
                wrong.lock().expect("no panic").push(message);
            }
        }
    };
    std::thread::scope(|scope| (0..2).for_each(|_| drop(scope.spawn(work))));
    let wrong = wrong.into_inner().expect("no panic");
    assert!(!faults.is_empty());
    let (bad, all) = (wrong.len(), faults.len());
    assert!(bad == 0, "{bad} of {all} faults:\n{}", wrong.join("\n"));
}

#[test]
fn any_call_may_fail() {
    sweep(some);
}

#[test]
#[ignore = "takes a minute; any_call_may_fail tries the calls at both ends and half-way"]
fn every_call_may_fail() {
    sweep(|calls| (1..=calls).collect());
}

/// By the last call, nearly all samples are done.
#[test]
fn samples_that_are_done_are_left_as_a_picture_and_a_part() {
    let Some(layer) = Layer::built() else { return };
    let (sound, counts) = sound(&layer);
    let last = counts["vkQueueSubmit"];
    for fault in [
        format!("vkQueueSubmit:{last}:-4,vkQueueSubmit:{}:-4", last + 1),
        format!("vkWaitForFences:{last}+:2"),
        format!("vkWaitForFences:{last}:-4,vkCreateDevice:2+:-3"),
        format!("vkQueueSubmit:{last}:-4,vkAllocateMemory:12+:-2"),
    ] {
        let trial = rendering(&layer, &fault);
        assert_eq!(trial.code, Some(7), "{fault}: {trial}");
        assert!(matches!(trial.picture, Left::Whole(_)), "{fault}: {trial}");
        assert_eq!(trial.report, Ok(true), "{fault}: {trial}");
        assert!(
            trial
                .err
                .contains("a.vkpt contains the samples done by then"),
            "{fault}: {trial}"
        );
        assert!(
            trial.err.contains("--resume --device cpu-f32"),
            "{fault}: {trial}"
        );
        assert!(
            trial.resumed.as_ref() == Some(&sound.picture),
            "{fault}: {trial}"
        );
    }
}

/// A device that comes back and is lost again, one that never works again, one that hangs, and several ways at once.
#[test]
fn devices_may_fail_again_and_again() {
    let Some(layer) = Layer::built() else { return };
    let (sound, counts) = sound(&layer);
    let last = counts["vkQueueSubmit"];
    let again = ["vkQueueSubmit", "vkWaitForFences"].map(|call| {
        let twice = [(1, 2), (3, last / 2), (last / 2, last), (last, last + 3)];
        twice.map(|(n, m)| format!("{call}:{n}:-4,{call}:{m}:-4"))
    });
    let ever = [
        "vkCreateDevice",
        "vkQueueSubmit",
        "vkWaitForFences",
        "vkAllocateMemory",
    ]
    .map(|call| [1, 3].map(|n| format!("{call}:{n}+:-4")));
    let hangs = [1, 3, last / 2, last].map(|n| format!("vkWaitForFences:{n}+:2"));
    let others = [
        format!("vkWaitForFences:{last}:2,vkCreateDevice:2+:-3"),
        format!("vkQueueSubmit:{last}:-4,vkCreateInstance:2+:-9"),
        format!("vkQueueSubmit:{last}:-4,vkAllocateMemory:12:-2"),
        format!("vkWaitForFences:{last}:2,vkWaitForFences:{}:-4", last + 2),
        "vkCreatePipelineCache:1+:-2,vkGetPipelineCacheData:1+:-2".to_owned(),
    ];
    let faults = again.concat().into_iter().chain(ever.concat());
    let faults = faults.chain(hangs).chain(others);
    all_as_expected(&layer, &sound, &faults.collect::<Vec<_>>());
}
