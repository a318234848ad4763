//! A difference in how two pictures or parts were made.

/// A property, and its values in both.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    name: String,
    /// `None` if they mean nothing to people, such as digests.
    values: Option<[String; 2]>,
}

impl Difference {
    /// `None` if the values are equal.
    pub fn new(name: &str, values: [String; 2]) -> Option<Self> {
        (values[0] != values[1]).then(|| Self {
            name: name.to_owned(),
            values: Some(values),
        })
    }

    /// A difference of values that are not shown.
    pub fn unshown(name: &str, values: [String; 2]) -> Option<Self> {
        let all = Self::new(name, values)?;
        Some(Self {
            values: None,
            ..all
        })
    }

    /// `--seed is 0 in a.vkpt and 3 in b.vkpt`, given the names of both.
    pub fn between(&self, [first, second]: [&str; 2]) -> String {
        let name = &self.name;
        match &self.values {
            Some([a, b]) => format!("{name} is {a} in {first} and {b} in {second}"),
            None => format!("{name} differs"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_names_are_given_with_their_values() {
        let pair = |a: &str, b: &str| [a.to_owned(), b.to_owned()];
        assert_eq!(Difference::new("spp", pair("16", "16")), None);
        let shown = Difference::new("spp", pair("16", "64")).expect("a difference");
        let unshown = Difference::unshown("the scene", pair("1f", "2f")).expect("a difference");
        assert_eq!(
            shown.between(["a.exr", "b.exr"]),
            "spp is 16 in a.exr and 64 in b.exr"
        );
        assert_eq!(unshown.between(["a.exr", "b.exr"]), "the scene differs");
    }
}
