//! A farm in a folder of its own, by a program that stands for vkpt.

use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::slurm::Slurm;
use crate::cli::program::{Run, SCENE, finish, run};
use crate::scripts::program::program;

/// A name that a shell would take apart.
pub const SCENE_NAME: &str = "it's a \"scene\" #1.txt";

/// What `vkpt farm slurm` left, ready to be submitted.
pub struct Farm {
    folder: TempDir,
}

impl Farm {
    /// The scripts of a scene, whose program takes so long for each sample.
    pub fn new(flags: &[&str], seconds_a_sample: f64) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join(SCENE_NAME), SCENE).expect("a scene");
        let all = [&["farm", "slurm", SCENE_NAME, "-o", "out/it's.exr"], flags].concat();
        fs::create_dir(folder.path().join("out")).expect("a folder");
        let made = run(folder.path(), &all);
        assert_eq!(made.code, Some(0), "{}", made.err);
        let body = format!(
            "export SECONDS_A_SAMPLE={seconds_a_sample}\n{}",
            include_str!("vkpt.sh")
        );
        let vkpt = program(folder.path(), "vkpt", &body);
        let farm = Self { folder };
        let text = farm
            .text("farm.sh")
            .replace(env!("CARGO_BIN_EXE_vkpt"), &vkpt.to_string_lossy());
        fs::write(farm.path("farm.sh"), text).expect("a script");
        farm
    }

    /// A file of the folder of scripts.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join("out/it's.farm").join(name)
    }

    pub fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect("a text")
    }

    /// Runs `submit.sh`, from elsewhere.
    pub fn submit(&self, slurm: &Slurm) -> Run {
        let submit = self.path("submit.sh");
        let run = finish(slurm.command("bash").arg(submit).current_dir("/"));
        assert_eq!(run.code, Some(0), "{}", run.err);
        run
    }

    /// The samples of the picture, one a line.
    pub fn picture(&self) -> String {
        fs::read_to_string(self.folder.path().join("out/it's.exr")).unwrap_or_default()
    }

    /// What all tasks, or all merges, have printed.
    pub fn logs(&self, begin: &str) -> String {
        let entries = fs::read_dir(self.path("logs")).expect("a folder").flatten();
        let named = |path: &PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with(begin)
        };
        let files = entries.map(|entry| entry.path()).filter(named);
        let texts = files.map(|path| fs::read_to_string(path).expect("a text"));
        texts.collect()
    }

    /// The processes that render a part, by their numbers.
    pub fn rendering(&self, part: &str) -> Vec<String> {
        let processes = fs::read_dir("/proc").expect("a folder").flatten();
        let renders = |path: &Path| {
            let words = fs::read_to_string(path.join("cmdline")).unwrap_or_default();
            let words: Vec<&str> = words.split('\0').collect();
            words.contains(&part)
                && words
                    .iter()
                    .any(|w| w.starts_with(&*self.path("parts").to_string_lossy()))
        };
        let mut ids = Vec::new();
        for path in processes
            .map(|entry| entry.path())
            .filter(|path| renders(path))
        {
            ids.extend(path.file_name().map(|id| id.to_string_lossy().into_owned()));
        }
        ids
    }
}

/// The picture of so many samples: one run's.
pub fn one_run(samples: u32) -> String {
    (0..samples).map(|sample| format!("{sample}\n")).collect()
}
