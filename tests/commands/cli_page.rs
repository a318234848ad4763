//! docs/cli.md lists every command, option and exit code as the program's own parser has them: below a mark the page is
//! generated, and compared with the file. To write it anew:
//!
//! ```sh
//! VKPT_BLESS=1 cargo test --test commands cli_page
//! ```

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use clap::{Arg, Command};
use vkpt_cli::command_line;

use crate::common::root;

/// The last line that is written by hand.
const MARK: &str =
    "<!-- From here on generated: VKPT_BLESS=1 cargo test --test commands cli_page -->\n";

/// The headings of options that commands share; they are listed once.
const SHARED: [&str; 2] = [
    "Model (what the picture converges to)",
    "Estimator (how fast it converges)",
];

/// The page below the mark.
fn page(mut program: Command) -> String {
    program.build();
    let render = program.find_subcommand("render").expect("render").clone();
    let mut page = String::new();
    overview(&mut page, &mut program, &render);
    let mut commands: Vec<&mut Command> = program.get_subcommands_mut().collect();
    commands.sort_by_key(|command| command.get_display_order());
    for command in commands {
        section(&mut page, command, &render);
    }
    page.push_str("\n## Settings\n\nCommands that render take all of these.\n");
    for heading in SHARED {
        options(&mut page, heading, &of(&render, Some(heading)));
    }
    page
}

/// The program itself: its commands, and the options that no command has.
fn overview(page: &mut String, program: &mut Command, render: &Command) {
    title(page, program);
    page.push_str("\n| command | |\n|---|---|\n");
    let mut commands: Vec<&Command> = program.get_subcommands().collect();
    commands.sort_by_key(|command| command.get_display_order());
    for command in commands {
        let (name, about) = (full_name(command), about(command));
        let anchor = name.replace(' ', "-");
        _ = writeln!(page, "| [`{name}`](#{anchor}) | {} |", cell(&about));
    }
    let of_render: BTreeSet<_> = render.get_arguments().map(Arg::get_id).collect();
    let own = program.get_arguments();
    let own = own.filter(|arg| arg.get_id() == "help" || !of_render.contains(arg.get_id()));
    options(page, "Options", &own.collect::<Vec<_>>());
    page.push_str("\nAll other options are those of `vkpt render`. Every command has `--help`.\n");
    after(page, program);
}

/// A command, and those in it.
fn section(page: &mut String, command: &mut Command, render: &Command) {
    title(page, command);
    let arguments: Vec<&Arg> = command.get_positionals().collect();
    if !arguments.is_empty() {
        page.push_str("\n| argument | meaning | default |\n|---|---|---|\n");
        arguments.iter().for_each(|arg| row(page, arg));
    }
    let headings = headings(command);
    let mut shares = 0;
    for heading in &headings {
        let of_command = of(command, *heading);
        let name = heading.unwrap_or("Options");
        if SHARED.contains(&name) && same(&of_command, &of(render, *heading)) {
            shares += 1;
        } else {
            options(page, name, &of_command);
        }
    }
    if shares == SHARED.len() {
        page.push_str("\nIt also takes all [settings](#settings).\n");
    }
    after(page, command);
    for command in command.get_subcommands_mut() {
        section(page, command, render);
    }
}

fn full_name(command: &Command) -> String {
    let name = command.get_bin_name().unwrap_or_else(|| command.get_name());
    name.to_owned()
}

fn about(command: &Command) -> String {
    command
        .get_about()
        .map(ToString::to_string)
        .expect("a help")
}

/// Heading, purpose and usage of a command.
fn title(page: &mut String, command: &mut Command) {
    let usage = command.render_usage().to_string();
    let (name, about) = (full_name(command), about(command));
    _ = write!(page, "\n## {name}\n\n{about}.\n\n```\n{usage}\n```\n");
}

/// The headings of a command's options, in the order of its help.
fn headings(command: &Command) -> Vec<Option<&str>> {
    let mut headings = vec![None];
    for arg in command.get_opts().chain(switches(command)) {
        let heading = arg.get_help_heading();
        if !headings.contains(&heading) {
            headings.push(heading);
        }
    }
    headings
}

/// The options of a command that take no value.
fn switches(command: &Command) -> impl Iterator<Item = &Arg> {
    let all = command.get_arguments();
    all.filter(|arg| !arg.is_positional() && !arg.get_action().takes_values())
}

/// The options below a heading, except help.
fn of<'c>(command: &'c Command, heading: Option<&str>) -> Vec<&'c Arg> {
    let all = command.get_arguments();
    let shown = all.filter(|arg| !arg.is_positional() && !arg.is_hide_set());
    shown
        .filter(|arg| arg.get_id() != "help" && arg.get_help_heading() == heading)
        .collect()
}

fn same(some: &[&Arg], others: &[&Arg]) -> bool {
    let row_of = |arg: &&Arg| {
        let mut text = String::new();
        row(&mut text, arg);
        text
    };
    some.iter().map(row_of).eq(others.iter().map(row_of))
}

fn options(page: &mut String, heading: &str, options: &[&Arg]) {
    if options.is_empty() {
        return;
    }
    _ = write!(
        page,
        "\n**{heading}**\n\n| option | meaning | default |\n|---|---|---|\n"
    );
    options.iter().for_each(|arg| row(page, arg));
}

/// An argument as a row of a table: its name, its help, its default.
fn row(page: &mut String, arg: &Arg) {
    let short = arg.get_short().map(|short| format!("`-{short}`, "));
    let help = arg.get_help().expect("a help").to_string();
    let (help, default_text) = help.rsplit_once(" [default").unwrap_or((&help, ""));
    let default_text = default_text
        .trim_end_matches(']')
        .trim_start_matches(':')
        .trim();
    let values = arg.get_default_values().iter();
    let values: Vec<_> = values.map(|value| value.to_string_lossy()).collect();
    // A switch is off by default, which is not shown.
    let default = match default_text.is_empty() && arg.get_action().takes_values() {
        true => values.join(" "),
        false => default_text.to_owned(),
    };
    let default = match default.is_empty() {
        true => default,
        false => format!(" {}", cell(&default)),
    };
    let short = short.unwrap_or_default();
    _ = writeln!(page, "| {short}`{arg}` | {} |{default} |", cell(help));
}

/// Text in a cell of a table, with Markdown's special characters escaped.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('*', "\\*")
}

/// Exit codes as a table, examples as a block, and the rest of the text after a command's options.
fn after(page: &mut String, command: &Command) {
    let Some(text) = command.get_after_help() else {
        return;
    };
    for paragraph in text.to_string().split("\n\n") {
        if let Some(codes) = paragraph.strip_prefix("Exit codes:\n") {
            page.push_str("\n| exit code | meaning |\n|---|---|\n");
            for (code, meaning) in codes_of(codes) {
                _ = writeln!(page, "| {code} | {} |", cell(&meaning));
            }
        } else if let Some(examples) = paragraph.strip_prefix("Examples:\n") {
            page.push_str("\n```sh\n");
            for line in examples.lines().map(str::trim) {
                // The comment on a line follows two blanks.
                match line.split_once("  ") {
                    Some((line, default_text)) => {
                        _ = writeln!(page, "{line:<52}  # {}", default_text.trim())
                    }
                    None => _ = writeln!(page, "{line}"),
                }
            }
            page.push_str("```\n");
        } else {
            _ = write!(page, "\n{paragraph}\n");
        }
    }
}

/// Codes and meanings, of which each may run over several lines.
fn codes_of(text: &str) -> Vec<(u8, String)> {
    let mut codes: Vec<(u8, String)> = Vec::new();
    for line in text.lines().map(str::trim) {
        let begun = line.split_once("  ").and_then(|(code, meaning)| {
            let code = code.parse().ok()?;
            Some((code, meaning.to_owned()))
        });
        match (begun, codes.last_mut()) {
            (Some(begun), _) => codes.push(begun),
            (None, Some((_, meaning))) => *meaning += &format!(" {line}"),
            (None, None) => panic!("no exit code: {line}"),
        }
    }
    codes
}

fn path() -> PathBuf {
    root().join("docs/cli.md")
}

/// The committed page, above the mark and below.
fn committed() -> (String, String) {
    let text = fs::read_to_string(path()).expect("the page");
    let (above, below) = text.split_once(MARK).expect("the mark");
    (above.to_owned(), below.to_owned())
}

#[test]
fn the_page_is_that_of_the_program() {
    let (above, below) = committed();
    let page = page(command_line());
    if std::env::var_os("VKPT_BLESS").is_some_and(|bless| bless == "1") {
        fs::write(path(), format!("{above}{MARK}{page}")).expect("the page");
        return;
    }
    let differs = below
        .lines()
        .zip(page.lines())
        .find(|(committed, generated)| committed != generated);
    assert!(
        below == page,
        "docs/cli.md is not what the program says: {differs:?}; VKPT_BLESS=1 cargo test --test commands cli_page writes it anew"
    );
}

/// Above the mark the page sums up the exit codes of all commands.
#[test]
fn the_summary_has_the_exit_codes_of_all_commands() {
    let (above, below) = committed();
    let codes = |text: &str| -> BTreeSet<u8> {
        let cells = text.lines().filter_map(|line| line.strip_prefix("| "));
        let firsts = cells.filter_map(|line| line.split(' ').next());
        firsts.filter_map(|code| code.parse().ok()).collect()
    };
    let (summary, mut all) = (codes(&above), codes(&below));
    // `143  the same by SIGTERM, 129 by SIGHUP`
    assert!(below.contains(", 129 by SIGHUP"));
    all.insert(129);
    assert_eq!(summary, all);
}

#[test]
fn a_new_option_or_another_default_is_seen() {
    let before = page(command_line());
    let planted = |change: fn(Command) -> Command| {
        let mut lines: Vec<String> = Vec::new();
        let after = page(command_line().mut_subcommand("converge", change));
        lines.extend(
            after
                .lines()
                .filter(|line| !before.contains(line))
                .map(str::to_owned),
        );
        lines.join("\n")
    };
    let option = planted(|command| {
        let option = Arg::new("new").long("new").value_name("N");
        command.arg(option.help("A | new* option [default: the scene's]"))
    });
    assert_eq!(
        option,
        "| `--new <N>` | A \\| new\\* option | the scene's |"
    );
    let default = planted(|command| command.mut_arg("replicates", |arg| arg.default_value("9")));
    assert!(default.ends_with("| 9 |"), "{default}");
    // A setting that only one command has is listed there.
    let setting = planted(|command| command.mut_arg("lobe", |arg| arg.help("Another help")));
    assert!(
        setting.contains("| `--lobe <RULE>` | Another help |"),
        "{setting}"
    );
    let codes =
        planted(|command| command.after_help("Exit codes:\n    9  one that\n       nobody knew"));
    assert_eq!(codes, "| 9 | one that nobody knew |");
}
