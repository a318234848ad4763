//! Meshes in temporary files, which live as long as their handle.

use tempfile::NamedTempFile;

/// The closed cube from −1 to 1.
pub fn cube() -> NamedTempFile {
    ply(
        "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n\
         element face 6\nproperty list uchar int vertex_indices\nend_header\n\
         -1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n\
         4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n",
    )
}

/// The square from −1 to 1 in the plane z = 0.
pub fn square() -> NamedTempFile {
    ply(
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         element face 1\nproperty list uchar int vertex_indices\nend_header\n\
         -1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n",
    )
}

/// The text after `format ascii 1.0` in a PLY file.
pub fn ply(rest: &str) -> NamedTempFile {
    let file = tempfile::Builder::new()
        .suffix(".ply")
        .tempfile()
        .expect("a temporary file");
    std::fs::write(file.path(), format!("ply\nformat ascii 1.0\n{rest}"))
        .expect("a temporary file");
    file
}
