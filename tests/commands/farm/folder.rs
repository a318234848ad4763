//! A farm in its own folder.

use std::fs;
use std::path::PathBuf;

use tempfile::TempDir;

use super::process::Process;
use super::slurm::{Slurm, until};
use crate::cli::program::{Run, finish, run};

/// A name that a shell would take apart.
const NAME: &str = "it's a \"scene\" #1.txt";

/// A floor in the light of a ball.
const SCENE: &str = "screen 8 6\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\nbrdf .5 .6 .7 0 0 0 1\n\
    box -9 -9 -2 18 18 1\n";

/// The folder of `vkpt farm slurm`, ready to be submitted.
pub struct Farm {
    folder: TempDir,
    size: &'static str,
}

impl Farm {
    /// The scripts for a picture of that size.
    pub fn new(size: &'static str, flags: &[&str]) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join(NAME), SCENE).expect("a scene");
        fs::create_dir(folder.path().join("out")).expect("a folder");
        let farm = Self { folder, size };
        let farmed = ["farm", "slurm", NAME, "-o", "out/it's.exr"];
        farm.vkpt(&[&farmed, flags].concat());
        farm
    }

    fn vkpt(&self, words: &[&str]) {
        let common = ["--device", "cpu-f32", "--size", self.size];
        let made = run(self.folder.path(), &[words, &common].concat());
        assert_eq!(made.code, Some(0), "{}", made.err);
    }

    /// A file of the folder of scripts.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join("out/it's.farm").join(name)
    }

    /// Runs `submit.sh`, from elsewhere.
    pub fn submit(&self, slurm: &Slurm) -> Run {
        let submit = self.path("submit.sh");
        let run = finish(slurm.command("bash").arg(submit).current_dir("/"));
        assert_eq!(run.code, Some(0), "{}", run.err);
        run
    }

    /// Whether the merge has left a picture.
    pub fn has_picture(&self) -> bool {
        self.folder.path().join("out/it's.exr").exists()
    }

    /// That the picture is, byte by byte, that of one run with so many samples.
    pub fn is_one_run_of(&self, spp: u32) {
        let scene = self.folder.path().join(NAME);
        let spp = spp.to_string();
        self.vkpt(&[&scene.to_string_lossy(), "--spp", &spp, "-o", "one.exr"]);
        let bytes = |name: &str| fs::read(self.folder.path().join(name)).ok();
        let same = bytes("one.exr") == bytes("out/it's.exr");
        assert!(same, "{}{}", self.logs("part"), self.logs("merge"));
    }

    /// The output of all tasks, or of all merges.
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

    /// The process that renders these samples, such as `0..256`; halted while it does.
    pub fn halted(&self, samples: &str) -> Process {
        let mut found = None;
        until("a part that is rendered", || {
            found = self.process(samples).filter(Process::has_begun);
            found.is_some()
        });
        let process = found.expect("it was waited for");
        process.send("STOP");
        process
    }

    fn process(&self, samples: &str) -> Option<Process> {
        let parts = self.path("parts").display().to_string();
        let all = fs::read_dir("/proc").expect("a folder").flatten();
        let mut all = all.map(|process| Process(process.path()));
        all.find(|process| {
            let words = process.says("cmdline");
            let words: Vec<&str> = words.split('\0').collect();
            words.contains(&samples) && words.iter().any(|word| word.starts_with(&parts))
        })
    }
}
