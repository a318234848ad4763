//! Describes a kind of shape: its names in scenes, and the text generated for it in kernels.

/// Paths of files are relative to `shaders/`, without `.glsl`. In GLSL, `{i}` is the index of a primitive, `{x}` the
/// primitive itself, `{best}` the nearest hit so far, and `{once}` a value computed once per ray.
#[derive(Debug)]
pub struct Description {
    /// The name in scene files.
    pub name: &'static str,
    /// Singular and plural for a primitive.
    pub primitives: [&'static str; 2],
    /// The array with one element per primitive.
    pub array: &'static str,
    /// A primitive's type.
    pub ty: &'static str,
    /// The declaration of `ty`, if it is a record.
    pub declaration: Option<fn() -> String>,
    /// Primitive `{i}` in its buffer.
    pub element: &'static str,
    /// Type and value shared by all tests of `ray`.
    pub once: Option<[&'static str; 2]>,
    /// The file with the test.
    pub nearer_file: &'static str,
    /// The nearer of `{best}` and the hit of `ray` with `{x}`; `skip` is ignored.
    pub nearer: &'static str,
    pub surface_file: &'static str,
    /// The surface of `{x}` at the `hit` of `ray`.
    pub surface: &'static str,
    pub face_file: &'static str,
    /// Whether `p`, in the plane of a `face` of `{x}`, is on that face.
    pub face_point: &'static str,
    pub light_file: &'static str,
    /// A direction from `p` to a point on the light `{x}`, sampled with `u24` and `u`; `{light}` is the light's record.
    pub light_sample: &'static str,
    /// The density of that sampling for the point on primitive `prim` at `distance` under `cosine`.
    pub light_pdf: &'static str,
    pub emission_file: &'static str,
    /// A point on the light `{x}`, uniform over its area, sampled with `u24` and `u`.
    pub emission: &'static str,
    /// The density per area of that sampling for the point on primitive `prim` that `p` sees along `wi`; 0 on the
    /// inside.
    pub emission_pdf: &'static str,
}

/// Replaces each placeholder of `places`.
pub fn filled(text: &str, places: &[(&str, &str)]) -> String {
    let fill = |text: String, (place, with): &(&str, &str)| text.replace(place, with);
    places.iter().fold(text.to_owned(), fill)
}
