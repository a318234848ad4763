//! Lines to read: one for each scene, and a summary.

use super::{Case, Suite, Verdict};
use vkpt::report::human::{duration, plural};

/// A line, followed by details of a failure.
pub fn line(case: &Case) -> String {
    let (word, more) = match &case.verdict {
        Verdict::Same => ("same", String::new()),
        Verdict::Close { rel_mse } => ("close", format!(", relMSE {rel_mse:.1e}")),
        Verdict::Kept { instead: true } => ("kept", ", replaces another".to_owned()),
        Verdict::Kept { instead: false } => ("kept", ", new".to_owned()),
        Verdict::Differs(_) => ("DIFFERS", String::new()),
        Verdict::Failed(_) => ("FAILED", String::new()),
    };
    let mut text = format!("{word:<8}{}  {}{more}\n", case.name, duration(case.seconds));
    if let Some(why) = case.verdict.wrong() {
        text += &format!("        {}\n", why.replace('\n', "\n        "));
    }
    if !case.files.is_empty() {
        text += &format!("        wrote {}\n", case.files.join(", "));
    }
    text
}

/// `12 scenes in 3.4 s: all passed`
pub fn sum(suite: &Suite) -> String {
    let all = suite.cases.len() as u64;
    let seconds = suite.cases.iter().map(|case| case.seconds).sum();
    let what = match suite.wrong() {
        0 => "all passed".to_owned(),
        wrong => format!("{wrong} failed"),
    };
    format!(
        "{} in {}: {what}\n",
        plural(all, "scene"),
        duration(seconds)
    )
}
