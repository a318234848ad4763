//! What a file asks for and the picture lacks: told once each, with how many things ask for it.

/// What was left out, and of what, in the order in which it was met.
#[derive(Default)]
pub(super) struct LeftOut(Vec<(String, Vec<String>)>);

impl LeftOut {
    /// Notes that `what` is so for the thing that messages call `of`.
    pub(super) fn note(&mut self, what: impl Into<String>, of: &str) {
        let what = what.into();
        let of = of.to_owned();
        match self.0.iter_mut().find(|(known, _)| *known == what) {
            Some((_, all)) if all.contains(&of) => {}
            Some((_, all)) => all.push(of),
            None => self.0.push((what, vec![of])),
        }
    }

    /// A sentence for each.
    pub(super) fn sentences(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(|(what, all)| match &all[..] {
            [only] => format!("{only}: {what}"),
            [first, more @ ..] => format!("{first} and {} more: {what}", more.len()),
            [] => what.clone(),
        })
    }
}
