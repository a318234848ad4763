//! Flags for another command line: parsed, so that errors are found now, and as they were typed.

use clap::{ArgMatches, Args, Command, Error, FromArgMatches};

/// A group of flags, and the words that were typed.
#[derive(Debug)]
pub struct Typed<T> {
    pub read: T,
    pub words: Vec<String>,
}

impl<T: Args> Args for Typed<T> {
    fn augment_args(command: Command) -> Command {
        T::augment_args(command)
    }

    fn augment_args_for_update(command: Command) -> Command {
        T::augment_args_for_update(command)
    }
}

impl<T: Args> FromArgMatches for Typed<T> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let read = T::from_arg_matches(matches)?;
        let words = words::<T>(matches);
        Ok(Self { read, words })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The flags of `T` with their values, in the order of their declaration; none that was omitted.
fn words<T: Args>(matches: &ArgMatches) -> Vec<String> {
    let group = T::augment_args(Command::new(""));
    let mut words = Vec::new();
    for flag in group.get_arguments() {
        let id = flag.get_id().as_str();
        let given = matches.value_source(id) == Some(clap::parser::ValueSource::CommandLine);
        let Some(name) = flag.get_long().filter(|_| given) else {
            continue;
        };
        words.push(format!("--{name}"));
        if flag.get_action().takes_values() {
            let values = matches.get_raw(id).into_iter().flatten();
            words.extend(values.map(|value| value.to_string_lossy().into_owned()));
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use vkpt_lab::cli::numbers::negative;
    use vkpt_lab::cli::{settings::SettingArguments, view::ViewArguments};

    #[derive(clap::Args, Debug)]
    struct Group {
        #[command(flatten)]
        view: ViewArguments,
        #[command(flatten)]
        settings: SettingArguments,
    }

    #[test]
    fn only_typed_flags_come_back() {
        let command = Typed::<Group>::augment_args(Command::new("test")).mut_args(negative);
        let typed = |words: &[&str]| {
            let matches = command.clone().try_get_matches_from(words)?;
            Typed::<Group>::from_arg_matches(&matches)
        };
        assert!(typed(&["test"]).expect("read").words.is_empty());
        let all = "--camera Eye --size 4x3 --crop 0,0,2,2 --strict --model handout --fresnel exact --distribution ggx --absorption segment \
            --radiance-scaling on --max-depth 3 --integrator path --lobe norms --normals visible --roulette 0.8 \
            --connect mis --lights power --sampler random";
        let words: Vec<&str> = all.split_whitespace().collect();
        let read = typed(&[&["test"], &words[..]].concat()).expect("read");
        assert_eq!(read.words, words);
        assert_eq!(read.read.view.size, Some([4, 3]));
        assert_eq!(command.get_arguments().count(), 17, "a flag is not tested");
    }
}
