//! The plot's colours. The SVG names the light ones; a page that follows its reader's dark theme swaps each for its
//! counterpart by a rule of CSS ([`Colour::all`]).

/// A colour in the SVG, and its counterpart on a dark page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour {
    pub light: [u8; 3],
    pub dark: [u8; 3],
}

const fn colour(light: u32, dark: u32) -> Colour {
    let [_, r, g, b] = light.to_be_bytes();
    let [_, dark_r, dark_g, dark_b] = dark.to_be_bytes();
    Colour {
        light: [r, g, b],
        dark: [dark_r, dark_g, dark_b],
    }
}

/// The background.
pub const PAPER: Colour = colour(0xff_ff_ff, 0x16_18_1b);
/// Titles and axes.
pub const INK: Colour = colour(0x1f_23_28, 0xe3_e6_ea);
/// Labels of ticks.
pub const MUTED: Colour = colour(0x57_60_6a, 0xa3_ab_b4);
/// Lines across the plot.
pub const GRID: Colour = colour(0xe6_e9_ec, 0x2b_2f_34);
/// Lines of slope −½; dashed.
pub const GUIDE: Colour = colour(0xa9_b1_b9, 0x5e_67_70);
/// The reference's own error; dotted.
pub const OWN: Colour = colour(0x4b_53_5c, 0xbd_c4_cc);

/// The variants' colours, distinguishable by colour-blind people: those of Okabe and Ito (Color Universal Design, 2008)
/// without yellow, which is hard to see on paper; some are darkened for the same reason. From the eighth variant on
/// they repeat, with another marker.
pub const SERIES: [Colour; 7] = [
    colour(0x00_66_a6, 0x5a_b4_ee),
    colour(0xc9_52_00, 0xff_94_4d),
    colour(0x00_87_62, 0x3c_cf_a4),
    colour(0xb4_55_8c, 0xe8_9c_c8),
    colour(0xa8_74_00, 0xf0_b9_3a),
    colour(0x2f_9b_d6, 0x9b_d5_f7),
    colour(0x55_55_5d, 0xb9_bc_c6),
];

impl Colour {
    /// Each of them once.
    pub fn all() -> impl Iterator<Item = Self> {
        [PAPER, INK, MUTED, GRID, GUIDE, OWN]
            .into_iter()
            .chain(SERIES)
    }

    /// The colour of variant `i`.
    pub fn of_variant(i: usize) -> Self {
        SERIES[i % SERIES.len()]
    }

    /// `#0066A6`: the light one, as in the SVG.
    pub fn hex(self) -> String {
        hex(self.light)
    }

    /// The dark one in the same form.
    pub fn dark_hex(self) -> String {
        hex(self.dark)
    }
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02X}{g:02X}{b:02X}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rule of CSS finds a role by its colour.
    #[test]
    fn no_colour_has_two_roles() {
        let mut all: Vec<String> = Colour::all().map(Colour::hex).collect();
        let count = all.len();
        all.sort();
        all.dedup();
        assert_eq!(all.len(), count);
        assert_eq!(SERIES[0].hex(), "#0066A6");
    }
}
