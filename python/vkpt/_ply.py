"""Arrays as PLY files: binary, little-endian, vertices in double precision."""

from typing import Any

import numpy as np


def encoded(vertices: Any, faces: Any, normals: Any = None) -> bytes:
    """The file of a triangle mesh; arrays of shape (n, 3), (m, 3) and, if any, (n, 3)."""
    vertices = _table("vertices", vertices, "<f8")
    indices = np.asarray(faces)
    if indices.size and not np.issubdtype(indices.dtype, np.integer):
        raise TypeError("faces are indices: an array of whole numbers")
    if indices.size and not 0 <= indices.min() <= indices.max() < len(vertices):
        raise ValueError(f"faces name vertices from 0 to {len(vertices) - 1}")
    indices = _table("faces", indices, "<u4")
    columns = ["x", "y", "z"]
    if normals is not None:
        normals = _table("normals", normals, "<f8")
        if len(normals) != len(vertices):
            raise ValueError("there must be a normal for each vertex")
        vertices = np.hstack([vertices, normals])
        columns += ["nx", "ny", "nz"]
    properties = "".join(f"property double {column}\n" for column in columns)
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n{properties}"
        f"element face {len(indices)}\nproperty list uchar uint vertex_indices\nend_header\n"
    )
    triangles = np.empty(len(indices), [("count", "u1"), ("corners", "<u4", 3)])
    triangles["count"] = 3
    triangles["corners"] = indices
    return b"".join([header.encode(), vertices.tobytes(), triangles.tobytes()])


def _table(name: str, values: Any, kind: str) -> Any:
    table = np.ascontiguousarray(values, kind)
    if table.ndim != 2 or table.shape[1] != 3:
        raise ValueError(f"{name} must have the shape (n, 3), not {table.shape}")
    return table
