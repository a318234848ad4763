//! A kind of shape in words: those of its scene, and the text that is generated for it in kernels.

/// Files are named below `shaders/`, without `.glsl`. In GLSL `{i}` stands for the number of a primitive, `{x}` for the
/// primitive itself, `{best}` for the nearest hit so far and `{once}` for what is calculated once a ray.
#[derive(Debug)]
pub struct Description {
    /// As the scene spells it.
    pub name: &'static str,
    /// One primitive, and several.
    pub primitives: [&'static str; 2],
    /// The array that has an element for each primitive.
    pub array: &'static str,
    /// A primitive's type.
    pub ty: &'static str,
    /// The declaration of `ty`, where it is a record.
    pub declaration: Option<fn() -> String>,
    /// Primitive `{i}` in its buffer.
    pub element: &'static str,
    /// Type and value of what all tests of `ray` share.
    pub once: Option<[&'static str; 2]>,
    /// The file with the test.
    pub nearer_file: &'static str,
    /// The nearer of `{best}` and the hit of `ray` with `{x}`; `skip` is passed over.
    pub nearer: &'static str,
    pub surface_file: &'static str,
    /// The surface of `{x}` where `ray` has its `hit`.
    pub surface: &'static str,
    pub face_file: &'static str,
    /// Whether `p`, in the plane of a `face` of `{x}`, lies on it.
    pub face_point: &'static str,
    pub light_file: &'static str,
    /// A direction from `p` to a point of the light `{x}`, by `u24` and `u`; `{light}` is the light's record.
    pub light_sample: &'static str,
    /// The density with which it would have been drawn, of the point of primitive `prim` that is `distance` away under
    /// `cosine`.
    pub light_pdf: &'static str,
    pub emission_file: &'static str,
    /// A point of the light `{x}`, uniform over its area, by `u24` and `u`.
    pub emission: &'static str,
    /// The density per area with which that draws a point of primitive `prim` that `p` sees along `wi`; 0 on the inside.
    pub emission_pdf: &'static str,
}

/// The text with these places filled.
pub fn filled(text: &str, places: &[(&str, &str)]) -> String {
    let fill = |text: String, (place, with): &(&str, &str)| text.replace(place, with);
    places.iter().fold(text.to_owned(), fill)
}
