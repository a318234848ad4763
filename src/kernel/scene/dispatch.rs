//! The text of a function that calls one of several by a number.

/// A function that chooses among functions of the same arguments.
pub struct Dispatch<'a> {
    /// Its return type.
    pub result: &'a str,
    pub name: &'a str,
    /// Type and name of each argument.
    pub arguments: &'a [(&'a str, &'a str)],
    /// The number by which it chooses.
    pub selector: &'a str,
}

impl Dispatch<'_> {
    /// The function, calling the expressions of `members`: without a switch if there is only one, otherwise the last
    /// serves as the default. `none` is its value without members.
    pub fn text(&self, members: &[(u32, String)], none: &str) -> String {
        let arguments: Vec<String> = self
            .arguments
            .iter()
            .map(|(ty, name)| format!("{ty} {name}"))
            .collect();
        let head = format!(
            "{} {}({}) {{\n",
            self.result,
            self.name,
            arguments.join(", ")
        );
        let body = match members {
            [] => format!("    return {none};\n"),
            [(_, only)] => format!("    return {only};\n"),
            [others @ .., (_, last)] => self.switch(others, last),
        };
        head + &body + "}\n"
    }

    fn switch(&self, members: &[(u32, String)], last: &str) -> String {
        let mut text = format!(
            "    {} result;\n    switch ({}) {{\n",
            self.result, self.selector
        );
        for (value, call) in members {
            text += &format!("        case {value}u: {{ result = {call}; break; }}\n");
        }
        text += &format!("        default: {{ result = {last}; break; }}\n");
        text + "    }\n    return result;\n"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const D: Dispatch = Dispatch {
        result: "float",
        name: "f",
        arguments: &[("uint", "kind"), ("float", "x")],
        selector: "kind",
    };

    #[test]
    fn one_member_needs_no_switch() {
        let text = D.text(&[(3, "g(x)".into())], "0.0");
        assert_eq!(text, "float f(uint kind, float x) {\n    return g(x);\n}\n");
    }

    #[test]
    fn no_member_leaves_the_neutral_value() {
        assert!(D.text(&[], "0.0").contains("return 0.0;"));
    }

    #[test]
    fn the_last_member_is_the_default() {
        let text = D.text(&[(0, "g(x)".into()), (2, "h(x)".into())], "0.0");
        assert!(text.contains("case 0u: { result = g(x); break; }"));
        assert!(text.contains("default: { result = h(x); break; }"));
        assert!(!text.contains("case 2u"));
    }
}
