//! Embeds every file of `shaders/`, so that the binary needs none at run time.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=shaders");
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap_or_default()).join("shaders");
    let mut paths = Vec::new();
    collect(&root, &mut paths)?;
    // By name, the order of lookups: `a` before `a/b`, which a path would put after `a.glsl`.
    paths.sort_by_key(|path| name(path, &root));
    let mut table = String::from("&[\n");
    for path in paths {
        let _ = writeln!(
            table,
            "    ({:?}, include_str!({path:?})),",
            name(&path, &root)
        );
    }
    table.push(']');
    fs::write(
        PathBuf::from(env::var("OUT_DIR").unwrap_or_default()).join("shaders.rs"),
        table,
    )
}

fn collect(folder: &Path, paths: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, paths)?;
        } else if path.extension().is_some_and(|e| e == "glsl" || e == "comp") {
            paths.push(path);
        }
    }
    Ok(())
}

/// The name of the file in `// uses:`: `/` between the parts on every system; without `.glsl`, with `.comp`.
fn name(path: &Path, root: &Path) -> String {
    let name = path
        .strip_prefix(root)
        .unwrap_or(path)
        .to_string_lossy()
        .replace('\\', "/");
    name.strip_suffix(".glsl")
        .map(str::to_owned)
        .unwrap_or(name)
}
