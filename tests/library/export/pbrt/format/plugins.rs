//! Directives and plugins, and the parameters of each.

use super::Statement;

/// Each directive and its words before parameters.
const DIRECTIVES: [(&str, usize); 18] = [
    ("Film", 1),
    ("PixelFilter", 1),
    ("Sampler", 1),
    ("Integrator", 1),
    ("Transform", 0),
    ("ConcatTransform", 0),
    ("Camera", 1),
    ("WorldBegin", 0),
    ("LightSource", 1),
    ("AreaLightSource", 1),
    ("MakeNamedMaterial", 1),
    ("NamedMaterial", 1),
    ("MakeNamedMedium", 1),
    ("MediumInterface", 2),
    ("AttributeBegin", 0),
    ("AttributeEnd", 0),
    ("ReverseOrientation", 0),
    ("Shape", 1),
];

/// Each plugin of a directive and its parameters.
const PLUGINS: [(&str, &str, &[&str]); 17] = [
    (
        "Film",
        "rgb",
        &[
            "integer xresolution",
            "integer yresolution",
            "integer pixelbounds",
            "bool savefp16",
        ],
    ),
    ("PixelFilter", "box", &["float xradius", "float yradius"]),
    ("Sampler", "independent", &["integer pixelsamples"]),
    ("Integrator", "volpath", &["integer maxdepth"]),
    (
        "Camera",
        "perspective",
        &["float fov", "float lensradius", "float focaldistance"],
    ),
    ("LightSource", "infinite", &["rgb L"]),
    ("AreaLightSource", "diffuse", &["rgb L", "bool twosided"]),
    ("MakeNamedMaterial", "diffuse", &["rgb reflectance"]),
    (
        "MakeNamedMaterial",
        "conductor",
        &[
            "spectrum eta",
            "spectrum k",
            "float roughness",
            "bool remaproughness",
        ],
    ),
    (
        "MakeNamedMaterial",
        "dielectric",
        &["float eta", "float roughness", "bool remaproughness"],
    ),
    ("MakeNamedMaterial", "interface", &[]),
    (
        "MakeNamedMedium",
        "homogeneous",
        &["rgb sigma_a", "rgb sigma_s"],
    ),
    ("Shape", "sphere", &["float radius"]),
    (
        "Shape",
        "cylinder",
        &["float radius", "float zmin", "float zmax"],
    ),
    ("Shape", "disk", &["float radius", "float height"]),
    ("Shape", "trianglemesh", &["point3 P", "integer indices"]),
    ("Shape", "plymesh", &["string filename"]),
];

/// The words of a directive, if it is one.
pub fn words(directive: &str) -> Option<usize> {
    let found = DIRECTIVES.iter().find(|(name, _)| *name == directive);
    found.map(|(_, words)| *words)
}

/// The errors in it.
pub fn check(statement: &Statement) -> Result<(), String> {
    let words = words(&statement.directive)
        .ok_or_else(|| format!("{} is no directive", statement.directive))?;
    if statement.words.len() != words {
        return Err(format!(
            "{} has {} words",
            statement.directive,
            statement.words.len()
        ));
    }
    let is_transform = statement.directive.ends_with("Transform");
    if statement.numbers.len() != if is_transform { 16 } else { 0 } {
        return Err(format!("{} numbers", statement.numbers.len()));
    }
    let mut plugins = PLUGINS
        .iter()
        .filter(|(name, ..)| *name == statement.directive);
    if statement.parameters.is_empty() && plugins.clone().next().is_none() {
        return Ok(());
    }
    let plugin = plugins.find(|(_, plugin, _)| *plugin == statement.plugin());
    let (.., takes) = plugin.ok_or_else(|| format!("{} is no plugin", statement.plugin()))?;
    let named = statement.directive.starts_with("MakeNamed");
    for (name, values) in &statement.parameters {
        let is_type = named && name == "string type";
        if !is_type && !takes.contains(&name.as_str()) {
            return Err(format!("{} takes no {name}", statement.plugin()));
        }
        legal(name, values)?;
    }
    Ok(())
}

/// Whether a parameter's values are of its type, and as many as it takes.
fn legal(name: &str, values: &[String]) -> Result<(), String> {
    let is = |test: fn(&str) -> bool| values.iter().all(|value| test(value));
    let float = |value: &str| value.parse::<f64>().is_ok_and(f64::is_finite);
    let many = matches!(name, "integer pixelbounds" | "integer indices" | "point3 P");
    let sound = match name.split(' ').next() {
        Some("integer") => is(|v| v.parse::<i32>().is_ok()) && (many || values.len() == 1),
        Some("float") => is(float) && values.len() == 1,
        Some("rgb") => is(float) && values.len() == 3,
        Some("spectrum") => is(float) && values.len().is_multiple_of(2),
        Some("point3") => is(float) && values.len().is_multiple_of(3),
        Some("bool") => is(|v| v == "true" || v == "false") && values.len() == 1,
        Some("string") => values.len() == 1,
        _ => false,
    };
    match sound {
        true => Ok(()),
        false => Err(format!("{name} has the values {values:?}")),
    }
}
