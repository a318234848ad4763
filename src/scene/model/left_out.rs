//! Features of a file that the picture lacks: each is reported once, with the number of objects that use it.

/// Each omission and the objects concerned, in order of occurrence.
#[derive(Default)]
pub(super) struct LeftOut(Vec<(String, Vec<String>)>);

impl LeftOut {
    /// Notes that `what` applies to the object that messages call `of`.
    pub(super) fn note(&mut self, what: impl Into<String>, of: &str) {
        let what = what.into();
        let of = of.to_owned();
        match self.0.iter_mut().find(|(known, _)| *known == what) {
            Some((_, all)) if all.contains(&of) => {}
            Some((_, all)) => all.push(of),
            None => self.0.push((what, vec![of])),
        }
    }

    /// One sentence for each.
    pub(super) fn sentences(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(|(what, all)| match &all[..] {
            [only] => format!("{only}: {what}"),
            [first, more @ ..] => format!("{first} and {} more: {what}", more.len()),
            [] => what.clone(),
        })
    }
}
