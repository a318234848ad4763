//! The commands: one row each, with the function that reads it.

use super::arguments::Arguments;
use super::builder::Builder;
use super::text::{Line, Token, shorten};
use super::{camera, foreign, lens, material, shape, surroundings, view};

struct Command {
    word: &'static str,
    usage: &'static str,
    read: fn(&mut Builder, &mut Arguments),
}

const COMMANDS: [Command; 14] = [
    Command {
        word: "screen",
        usage: "screen W H",
        read: view::screen,
    },
    Command {
        word: "camera",
        usage: "camera ex ey ez  ry  ORIENTATION",
        read: camera::camera,
    },
    Command {
        word: "lens",
        usage: "lens RADIUS FOCUS",
        read: lens::lens,
    },
    Command {
        word: "ambient",
        usage: "ambient r g b",
        read: ambient,
    },
    Command {
        word: "background",
        usage: "background r g b  or  background FILE [SCALE] ORIENTATION",
        read: surroundings::background,
    },
    Command {
        word: "ibl",
        usage: "ibl FILE [SCALE] ORIENTATION",
        read: surroundings::ibl,
    },
    Command {
        word: "brdf",
        usage: "brdf  Kd(3) Ks(3) alpha  [Kt(3) ior]",
        read: material::brdf,
    },
    Command {
        word: "light",
        usage: "light r g b",
        read: material::light,
    },
    Command {
        word: "distribution",
        usage: "distribution auto|phong|beckmann|ggx",
        read: material::distribution,
    },
    Command {
        word: "fresnel",
        usage: "fresnel schlick|exact",
        read: material::fresnel,
    },
    Command {
        word: "sphere",
        usage: "sphere cx cy cz  r",
        read: shape::sphere,
    },
    Command {
        word: "box",
        usage: "box bx by bz  dx dy dz",
        read: shape::cuboid,
    },
    Command {
        word: "cylinder",
        usage: "cylinder bx by bz  ax ay az  r",
        read: shape::cylinder,
    },
    Command {
        word: "mesh",
        usage: "mesh FILE  tx ty tz  s  ORIENTATION",
        read: shape::mesh,
    },
];

/// Reads one line into the scene under construction in `builder`.
pub(super) fn read_line(builder: &mut Builder, line: Line<'_>) {
    let Some(command) = COMMANDS.iter().find(|command| command.word == line[0].text) else {
        unknown(builder, line[0]);
        return;
    };
    let mut arguments = Arguments::new(line, command.usage);
    let errors = builder.log.errors();
    (command.read)(builder, &mut arguments);
    // After an error, unread arguments say nothing.
    if builder.log.errors() == errors {
        arguments.finish(&mut builder.log);
    }
}

/// Warns about an unknown command. For a command of another program of the course, the message says how the picture
/// differs without it.
fn unknown(builder: &mut Builder, command: Token<'_>) {
    let (message, help) = match foreign::lacking(command.text) {
        Some(lacking) => (
            format!("`{}` is not supported: {}", command.text, lacking.what),
            lacking.help,
        ),
        None => {
            let words = COMMANDS.map(|command| command.word);
            let help = match closest(command.text, &words) {
                Some(word) => format!("did you mean `{word}`?"),
                None => format!("the commands are {}", words.join(", ")),
            };
            let message = format!("unknown command `{}`", shorten(command.text));
            (message, Some(help))
        }
    };
    let warning = builder
        .log
        .warning(command.place, message, "this line is skipped");
    if let Some(help) = help {
        warning.help(help);
    }
}

/// The entry of `words` that resembles `word`: at most a third of its letters differ, ignoring case.
pub(super) fn closest<'w>(word: &str, words: &[&'w str]) -> Option<&'w str> {
    // A long token is no misspelling, and computing the distance takes quadratic time.
    if word.len() > 40 {
        return None;
    }
    let word = word.to_lowercase();
    let distance = |other: &str| strsim::osa_distance(&word, other);
    let best = words.iter().copied().min_by_key(|other| distance(other))?;
    (distance(best) <= best.len().div_ceil(3).min(3) && distance(best) < best.len()).then_some(best)
}

/// The course's first projects used it; a path tracer has no use for it.
fn ambient(_: &mut Builder, arguments: &mut Arguments) {
    arguments.skip();
}
