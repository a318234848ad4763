//! How a rendering ends whose device fails.

use super::trial::{Left, Trial};

/// Conditions of every end, and of this fault's.
pub fn check(fault: &str, trial: &Trial, sound: &Trial) -> Result<(), String> {
    whole(trial)?;
    let no = |why: &str| Err(why.to_owned());
    match trial.code {
        Some(0) if trial.picture != sound.picture => no("another picture than without faults"),
        Some(0) if trial.report != Ok(true) => no("no report"),
        Some(0) => Ok(()),
        _ if !names_it(fault, &trial.err) => no("no word of what failed"),
        code if !codes(fault).contains(&code.unwrap_or_default()) => no("the wrong exit code"),
        // Samples were done, and are not lost.
        Some(7) if matches!(trial.picture, Left::Whole(_)) => match &trial.resumed {
            Some(resumed) if *resumed == sound.picture => Ok(()),
            Some(_) => no("it went on to another picture"),
            None => no("exit code 7 with a picture, and nothing to go on from"),
        },
        Some(7) if trial.resumed.is_some() => no("exit code 7 without a picture"),
        _ if trial.picture != Left::Old || trial.report != Ok(false) => no("it failed, and wrote"),
        _ => Ok(()),
    }
}

/// The exit codes that this fault may end with, if it does not end well: the only place that knows which faults a rendering
/// survives.
fn codes(fault: &str) -> Vec<i32> {
    let (call, rest) = fault.split_once(':').unwrap_or_default();
    let memory_or_lost = [":-1", ":-2", ":-4"].iter().any(|end| fault.ends_with(end));
    match call {
        // There may be no driver at all.
        "vkCreateInstance" if fault.ends_with(":-9") => vec![4],
        // A file that cannot be opened is not tried again.
        "vkCreateInstance" | "vkEnumeratePhysicalDevices" | "vkCreateDevice" if !memory_or_lost => {
            vec![1]
        }
        // One failure is survived: the device is opened anew.
        _ if !rest.contains([',', '+']) => vec![],
        _ => vec![7],
    }
}

/// No panic, no signal, no hang, and no file that is not whole.
fn whole(trial: &Trial) -> Result<(), String> {
    if trial.hung {
        return Err("it hangs".to_owned());
    }
    if trial.code.is_none() {
        return Err("a signal ended it".to_owned());
    }
    if trial.code == Some(101) || trial.err.contains("panicked") {
        return Err("a panic".to_owned());
    }
    if let Left::Broken(why) = &trial.picture {
        return Err(format!("a broken picture: {why}"));
    }
    if trial.picture == Left::Nothing {
        return Err("the old picture is gone".to_owned());
    }
    if let Err(why) = &trial.report {
        return Err(format!("a broken report: {why}"));
    }
    // A state from which a rendering can be resumed.
    let state = |name: &&String| !name.starts_with('.') && name.ends_with(".vkpt");
    match trial.others.iter().find(|name| !state(name)) {
        Some(name) => Err(format!("{name} lies about")),
        None => Ok(()),
    }
}

/// Whether the message names the failure: the call, or its meaning for a user.
fn names_it(fault: &str, err: &str) -> bool {
    let call = |fault: &str| fault.split(':').next().unwrap_or_default().to_owned();
    let printed = [
        "out of memory on the device",
        "the device was lost",
        "the device did not finish",
        "no Vulkan device",
    ];
    let error = err.lines().any(|line| line.starts_with("error: "));
    let named = fault.split(',').any(|one| err.contains(&call(one)));
    error && (named || printed.iter().any(|words| err.contains(words)))
}
