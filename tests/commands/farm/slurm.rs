//! A Slurm of one machine: munged, slurmctld and slurmd in a temporary folder, on their own ports. They end with it.
//!
//! <https://slurm.schedmd.com/slurm.conf.html>

use std::fs;
use std::net::TcpListener;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::common::needs::Need;

/// No step of a test takes longer.
const PATIENCE: Duration = Duration::from_secs(60);

pub struct Slurm {
    daemons: Vec<Child>,
    folder: TempDir,
}

impl Slurm {
    /// `None` if the run skips Slurm. Its four CPUs need not exist.
    pub fn start() -> Option<Self> {
        Need::Slurm.find(|| {
            let missing = ["munged", "slurmctld", "slurmd", "sbatch"].into_iter();
            let missing = missing.filter(|name| program(name).is_none());
            match missing.collect::<Vec<_>>()[..] {
                [] => Ok(()),
                ref names => Err(format!("not installed: {}", names.join(", "))),
            }
        })?;
        let folder = tempfile::tempdir().expect("a folder");
        let mut slurm = Self {
            daemons: Vec::new(),
            folder,
        };
        slurm.configure();
        let at = |name: &str| slurm.folder.path().join(name).display().to_string();
        let munged = [
            "--foreground".to_owned(),
            "--force".to_owned(),
            format!("--key-file={}", at("key")),
            format!("--socket={}", at("munge")),
            format!("--pid-file={}", at("munged.pid")),
            format!("--seed-file={}", at("seed")),
        ];
        slurm.daemon("munged", &munged.each_ref().map(String::as_str));
        until("munged", || slurm.folder.path().join("munge").exists());
        slurm.daemon("slurmctld", &["-D", "-c"]);
        slurm.daemon("slurmd", &["-D", "-N", "n1"]);
        until("a node that is idle", || {
            slurm.says(&["sinfo", "-h", "-o", "%T"]) == "idle"
        });
        Some(slurm)
    }

    fn configure(&self) {
        let folder = self.folder.path();
        let private = |name: &str, text: &str| {
            let path = folder.join(name);
            fs::write(&path, text).expect("a file");
            fs::set_permissions(path, fs::Permissions::from_mode(0o600)).expect("a file");
        };
        private("key", &"no secret ".repeat(8));
        for name in ["state", "spool"] {
            fs::create_dir(folder.join(name)).expect("a folder");
        }
        let [user, host] = [&["id", "-un"][..], &["hostname", "-s"]].map(|words| self.says(words));
        let [controller, node] = free_ports();
        let folder = folder.display();
        private(
            "slurm.conf",
            &format!(
                "ClusterName=test
                SlurmctldHost=localhost(127.0.0.1)
                SlurmUser={user}
                SlurmdUser={user}
                AuthType=auth/munge
                CredType=cred/munge
                AuthInfo=socket={folder}/munge,cred_expire=5
                SlurmctldPort={controller}
                SlurmctldPidFile={folder}/slurmctld.pid
                SlurmctldLogFile={folder}/slurmctld.log
                SlurmdPidFile={folder}/slurmd.pid
                SlurmdLogFile={folder}/slurmd.log
                SlurmdSpoolDir={folder}/spool
                StateSaveLocation={folder}/state
                ProctrackType=proctrack/linuxproc
                TaskPlugin=task/none
                SelectType=select/cons_tres
                SelectTypeParameters=CR_Core
                SlurmdParameters=config_overrides
                MpiDefault=none
                KillWait=5
                SchedulerParameters=batch_sched_delay=0,sched_interval=1
                AccountingStorageType=accounting_storage/none
                JobAcctGatherType=jobacct_gather/none
                NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={node} CPUs=4
                PartitionName=main Nodes=n1 Default=YES\n"
            ),
        );
    }

    /// Starts a program that ends with the thread that started it, if not before.
    fn daemon(&mut self, name: &str, arguments: &[&str]) {
        let log = fs::File::create(self.folder.path().join(name).with_extension("out"));
        let mut command = self.command("setpriv");
        let command = command.args(["--pdeathsig", "KILL"]);
        let program = program(name).expect("it is installed");
        let command = command.arg(program).args(arguments).stdin(Stdio::null());
        let (out, err) = (Stdio::null(), log.expect("a file"));
        let daemon = command.stdout(out).stderr(err).spawn();
        self.daemons.push(daemon.expect("setpriv runs"));
    }

    /// A program that asks this Slurm.
    pub fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        // Which jobs are submitted with, too: with a thread each, parts take as long on large machines as on small ones.
        command
            .env("SLURM_CONF", self.folder.path().join("slurm.conf"))
            .env("RAYON_NUM_THREADS", "1");
        command
    }

    /// The output of a command, without the end of the line.
    pub fn says(&self, words: &[&str]) -> String {
        let output = self.command(words[0]).args(&words[1..]).output();
        let text = String::from_utf8(output.expect("it runs").stdout);
        text.expect("UTF-8").trim_end().to_owned()
    }

    /// Jobs, and tasks of arrays, that are in a state such as `R`.
    pub fn jobs(&self, state: &str) -> Vec<String> {
        let jobs = self.says(&["squeue", "-h", "-r", "-t", state, "-o", "%i"]);
        jobs.lines().map(str::to_owned).collect()
    }

    /// Waits until every job has ended.
    pub fn finish(&self) {
        until("the end of all jobs", || {
            self.says(&["squeue", "-h"]).is_empty()
        });
    }
}

impl Drop for Slurm {
    fn drop(&mut self) {
        // Jobs outlive slurmd.
        self.says(&["scancel", "--user", &self.says(&["id", "-un"])]);
        let start = Instant::now();
        while !self.jobs("R,CG").is_empty() && start.elapsed() < PATIENCE {
            std::thread::sleep(Duration::from_millis(50));
        }
        for mut daemon in self.daemons.drain(..).rev() {
            let _ = daemon.kill().and_then(|()| daemon.wait());
        }
    }
}

/// Waits until it is so.
///
/// # Panics
/// Where it takes too long.
pub fn until(what: &str, mut is_so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(
            start.elapsed() < PATIENCE,
            "{what}: not within {PATIENCE:?}"
        );
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// Where a program is, in PATH or where daemons are.
fn program(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::env::split_paths(&path).chain(["/usr/sbin".into()]);
    let mut files = folders.map(|folder: PathBuf| folder.join(name));
    files.find(|file: &PathBuf| Path::is_file(file))
}

/// Two free ports.
fn free_ports() -> [u16; 2] {
    let listeners = [(); 2].map(|()| TcpListener::bind("127.0.0.1:0").expect("a port"));
    listeners.map(|l| l.local_addr().expect("an address").port())
}
