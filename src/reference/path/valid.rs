//! Shading normals that `wo` sees, and delta directions that leave the face on the intended side (model.md, "Valid
//! shading normals"); twin of `shaders/path/valid/`.

use crate::prepared::MaterialKind;
use crate::reference::bsdf::LOBE_DELTA;
use crate::reference::math::{Real, Vec3, dot3, normalize3};

/// The least wo·n of a normal.
pub const SEEN: f64 = 1e-3;
/// Height over the face of a direction that had to be lifted.
pub const LIFT: f64 = 1e-2;

/// The shading normal `n` of a surface that mirrors or refracts, turned just enough that `wo` sees it. `facing`: the face's
/// normal on wo's side; where it is `n` itself, nothing is turned.
///
/// n + (SEEN − wo·n) wo: there Fresnel's reflectance is almost 1, as on the rim of the intended smooth surface.
pub fn seen_normal<F: Real>(
    n: Vec3<F>,
    facing: Vec3<F>,
    wo: Vec3<F>,
    kind: MaterialKind,
) -> Vec3<F> {
    let c = dot3(n, wo);
    let specular = !matches!(kind, MaterialKind::Black | MaterialKind::Diffuse);
    if c < F::new(SEEN) && specular && n != facing {
        normalize3(n + wo * (F::new(SEEN) - c))
    } else {
        n
    }
}

/// The direction `wi` of a lobe, lifted just enough that it leaves the face on the side that `wi_z`, its cosine to the
/// shading normal `n`, indicates. Only a delta lobe's direction can be lifted: other densities would change with it.
///
/// wi + (LIFT − wi·g) g, g the face's normal on that side: as if the normal had been turned (Keller et al., The Iray Light
/// Transport Simulation and Rendering System, 2017, section 4.3).
pub fn leaving_direction<F: Real>(
    n: Vec3<F>,
    facing: Vec3<F>,
    wi: Vec3<F>,
    wi_z: F,
    lobe: u32,
) -> Vec3<F> {
    let g = if wi_z > F::zero() { facing } else { -facing };
    let up = dot3(wi, g);
    if up <= F::zero() && lobe >= LOBE_DELTA && n != facing {
        normalize3(wi + g * (F::new(LIFT) - up))
    } else {
        wi
    }
}
