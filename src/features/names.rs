//! Features in words.

use std::collections::BTreeSet;
use std::fmt::{self, Debug};

use super::Features;

impl Features {
    /// One phrase per feature, for people and for the JSON report; different kernels have different names.
    pub fn names(&self) -> Vec<String> {
        let set = |name: &str, members: String| format!("{name}: {members}");
        let mut names = vec![
            set("shapes", list(&self.shapes)),
            set("in a hierarchy", list(&self.in_bvh)),
            set("covered where faces coincide", list(&self.covered)),
            set("materials", list(&self.materials)),
            set("distributions", list(&self.distributions)),
            set("fresnel", list(&self.fresnel)),
            set("lights", list(&self.lights)),
            set("light picked by", list(&self.picks)),
            set("integrator", words(&self.integrator)),
            set("normals", words(&self.normals)),
            set("lobe", words(&self.lobe)),
            set("connect", words(&self.connect)),
            set("sampler", words(&self.sampler)),
            set("roulette", words(&self.roulette)),
        ];
        if let Some(absorption) = self.absorption {
            names.push(set("absorption", words(&absorption)));
        }
        let optional = [
            (self.diffuse_beside, "diffuse with specular"),
            (self.shading_normals, "shading normals"),
            (self.aims, "aimed light paths"),
            (self.lens, "lens"),
            (self.radiance_scaling, "radiance scaling"),
            (self.max_depth, "longest path"),
        ];
        names.extend(optional.iter().filter(|o| o.0).map(|o| o.1.to_owned()));
        if !self.aovs.is_empty() {
            names.push(set("other outputs", list(&self.aovs)));
        }
        names
    }
}

/// All names in one line.
impl fmt::Display for Features {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.names().join("; "))
    }
}

/// The words of a member's name: `RoughDielectric` becomes "rough dielectric".
pub fn words(member: &impl Debug) -> String {
    let mut words = String::new();
    for c in format!("{member:?}").chars() {
        if c.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(c.to_lowercase());
    }
    words
}

fn list<T: Debug>(set: &BTreeSet<T>) -> String {
    if set.is_empty() {
        return "none".into();
    }
    set.iter().map(words).collect::<Vec<_>>().join(", ")
}
