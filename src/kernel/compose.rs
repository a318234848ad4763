//! Decides which files a kernel contains, and their order.
//!
//! A file's header names its dependencies, `// uses: math/vec, math/frame, <normals>`: paths below `shaders/` without
//! `.glsl`, `constants/NAME`, which the host declares, and slots, which the composer fills with a file or with
//! generated text. A file is in the kernel, once, or it is not; there is no `#ifdef`.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use super::composed::Composed;
use super::constants;
use super::error::KernelError;
use super::sources;

/// The text that replaces `<name>` in files.
#[derive(Clone, Debug)]
pub enum Slot {
    /// A file, by its path below `shaders/` without `.glsl`.
    File(String),
    /// Generated text, which may have `// uses:` lines of its own.
    Text(String),
}

/// A custom shader file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OwnFile<'a> {
    /// Its path below `shaders/` without `.glsl`: that of the file that it replaces, or another that one of these uses.
    pub name: &'a str,
    pub text: &'a str,
}

/// Collects the parts of a kernel; [`compose`](Composer::compose) puts them in order.
#[derive(Clone, Debug, Default)]
pub struct Composer {
    prelude: Vec<String>,
    slots: BTreeMap<String, Slot>,
    added: BTreeMap<String, String>,
}

impl Composer {
    pub fn new() -> Self {
        Self::default()
    }

    /// Text before all files: structs, buffers, constants. Repeated calls append.
    pub fn prelude(mut self, text: impl Into<String>) -> Self {
        self.prelude.push(text.into());
        self
    }

    /// Fills the slot `<name>`.
    pub fn slot(mut self, name: &str, slot: Slot) -> Self {
        self.slots.insert(name.to_owned(), slot);
        self
    }

    /// Adds a file that is not in `shaders/`, or one in place of its namesake there.
    pub fn add(mut self, name: &str, text: impl Into<String>) -> Self {
        self.added.insert(name.to_owned(), text.into());
        self
    }

    /// `#version`, the prelude, then `roots` in order, each after everything that it uses.
    pub fn compose(&self, roots: &[&str]) -> Result<Composed, KernelError> {
        let mut walk = Walk {
            composer: self,
            done: BTreeSet::new(),
            open: Vec::new(),
            out: Composed::new(),
        };
        for text in &self.prelude {
            walk.file("<prelude>", text)?;
        }
        for root in roots {
            walk.visit(root)?;
        }
        Ok(walk.out)
    }

    fn text(&self, name: &str) -> Option<Cow<'_, str>> {
        let added = self.added.get(name).map(String::as_str);
        added
            .or_else(|| sources::file(name))
            .map(Cow::from)
            .or_else(|| constants::text(name).map(Cow::from))
    }
}

/// Depth-first: a file is written once everything that it uses has been.
struct Walk<'a> {
    composer: &'a Composer,
    done: BTreeSet<String>,
    /// The chain of files being resolved, outermost first.
    open: Vec<String>,
    out: Composed,
}

impl Walk<'_> {
    /// `name`: a file, or a slot in angle brackets.
    fn visit(&mut self, name: &str) -> Result<(), KernelError> {
        if self.done.contains(name) {
            return Ok(());
        }
        if let Some(from) = self.open.iter().position(|n| n == name) {
            let mut chain = self.open[from..].to_vec();
            chain.push(name.to_owned());
            return Err(KernelError::Cycle { chain });
        }
        self.open.push(name.to_owned());
        match name.strip_prefix('<').and_then(|n| n.strip_suffix('>')) {
            Some(slot) => self.slot(slot, name)?,
            None => {
                let text = self
                    .composer
                    .text(name)
                    .ok_or_else(|| self.unknown_file(name))?;
                self.file(name, &text)?;
            }
        }
        self.open.pop();
        self.done.insert(name.to_owned());
        Ok(())
    }

    fn slot(&mut self, slot: &str, name: &str) -> Result<(), KernelError> {
        match self.composer.slots.get(slot) {
            Some(Slot::File(file)) => self.visit(file),
            Some(Slot::Text(text)) => self.file(name, text),
            None => Err(KernelError::UnknownSlot {
                slot: slot.to_owned(),
                asked_by: self.asked_by(),
            }),
        }
    }

    fn file(&mut self, name: &str, text: &str) -> Result<(), KernelError> {
        for used in uses(text) {
            self.visit(used)?;
        }
        self.out.append(name, text);
        Ok(())
    }

    fn unknown_file(&self, name: &str) -> KernelError {
        KernelError::UnknownFile {
            name: name.to_owned(),
            asked_by: self.asked_by(),
        }
    }

    /// The file that uses the innermost open one.
    fn asked_by(&self) -> String {
        let n = self.open.len();
        if n >= 2 {
            self.open[n - 2].clone()
        } else {
            "the kernel".to_owned()
        }
    }
}

/// The names on the `// uses:` lines of a file.
fn uses(text: &str) -> impl Iterator<Item = &str> {
    text.lines()
        .filter_map(|line| line.trim_start().strip_prefix("// uses:"))
        .flat_map(|names| names.split(','))
        .map(str::trim)
        .filter(|name| !name.is_empty())
}
