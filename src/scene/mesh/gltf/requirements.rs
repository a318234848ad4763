//! The requirements of a document: its glTF version and extensions.

use serde::Deserialize;
use serde_json::Value;

use super::document::Extensions;
use crate::scene::text::quote;

/// Extensions that a file may require: they change only data that is not read, or the type of numbers.
const HARMLESS: [&str; 9] = [
    "KHR_mesh_quantization",
    "KHR_materials_",
    "KHR_texture_",
    "KHR_lights_",
    "KHR_animation_",
    "KHR_xmp",
    "EXT_texture_",
    "EXT_lights_",
    "MSFT_texture_",
];

/// Extensions that store vertices and triangles in their own format.
const COMPRESSIONS: [&str; 3] = [
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
];

/// The part of a document that is the same in all versions.
#[derive(Deserialize)]
struct Head {
    asset: Option<Asset>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Asset {
    /// A string, but some exporters write a number.
    version: Option<Value>,
    min_version: Option<Value>,
}

/// Refuses versions other than 2.x, and files that require more than 2.0. This check comes first, because other
/// versions have other JSON.
pub(super) fn version(json: &str) -> Result<(), String> {
    let head: Head = serde_json::from_str(json).map_err(|error| not_understood(&error))?;
    let asset = head.asset.as_ref();
    let Some(version) = asset.and_then(|asset| asset.version.as_ref()) else {
        return Err("it has no `asset.version`, which glTF 2.0 requires".into());
    };
    let least = asset.and_then(|asset| asset.min_version.as_ref());
    let (version, least) = (text(version), least.map(text));
    if version.split('.').next() != Some("2") {
        let version = quote(&version);
        return Err(format!(
            "it is glTF {version}, but only 2.0 is supported: convert it"
        ));
    }
    let above = |least: &String| least.parse().is_ok_and(|least: f64| least > 2.0);
    match least.filter(above) {
        Some(least) => Err(format!(
            "it needs glTF {} or later, but only 2.0 is supported: export it as glTF 2.0",
            quote(&least)
        )),
        None => Ok(()),
    }
}

/// The message for JSON that is not glTF.
pub(in crate::scene) fn not_understood(error: &serde_json::Error) -> String {
    format!("cannot read its JSON: {error}")
}

fn text(value: &Value) -> String {
    value
        .as_str()
        .map_or_else(|| value.to_string(), str::to_owned)
}

/// Refuses required extensions that affect the mesh and are not supported.
pub(super) fn extensions(required: &[String]) -> Result<(), String> {
    let harmless = |name: &&String| HARMLESS.iter().any(|start| name.starts_with(start));
    let unknown: Vec<&String> = required.iter().filter(|name| !harmless(name)).collect();
    let names: Vec<_> = unknown
        .iter()
        .map(|name| format!("`{}`", quote(name)))
        .collect();
    let (extensions, are) = match &names[..] {
        [] => return Ok(()),
        [_] => ("extension", "is"),
        _ => ("extensions", "are"),
    };
    let compressed = unknown
        .iter()
        .any(|name| COMPRESSIONS.contains(&name.as_str()));
    let remedy = match compressed {
        true => ": its mesh is compressed, save it without compression",
        false => "",
    };
    let names = names.join(", ");
    Err(format!(
        "it requires the {extensions} {names}, which {are} not supported{remedy}"
    ))
}

/// The message `what` about wrong data, with a hint if the data may also exist in compressed form.
pub(super) fn or_compressed(what: String, extensions: &Extensions) -> String {
    match COMPRESSIONS
        .iter()
        .find(|name| extensions.contains_key(**name))
    {
        Some(name) => format!("{what}: it is compressed by {name}, save it without compression"),
        None => what,
    }
}
