//! Irradiance at a surface element from a polygon of uniform radiance.

use glam::DVec3;

/// Irradiance at the origin, whose normal is `n`, from a polygon of radiance 1 that lies above its horizon. Its corners
/// are in order, in either sense: E = ½ |Σ Θ_i Γ_i·n|, Θ_i the angle that edge i subtends, Γ_i the normal of
/// its plane through the origin (Lambert 1760; Baum, Rushmeier & Winget, SIGGRAPH 1989, eq. 2).
pub fn irradiance(corners: &[DVec3], n: DVec3) -> f64 {
    let edge = |i: usize| {
        let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
        let normal = a.cross(b);
        let angle = normal.length().atan2(a.dot(b));
        angle * normal.normalize().dot(n)
    };
    0.5 * (0..corners.len()).map(edge).sum::<f64>().abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of half side a, h above: E = 4 a/√(a² + h²) atan(a/√(a² + h²)), four times that of a quarter (Howell's
    /// catalogue, C-11); a very large one is the sky, π.
    #[test]
    fn squares_are_known() {
        let square =
            |a: f64, h: f64| [(-a, -a), (a, -a), (a, a), (-a, a)].map(|(x, y)| DVec3::new(x, y, h));
        for (a, h) in [(1.0, 1.0), (0.1, 2.0), (5.0, 0.3)] {
            let s = f64::hypot(a, h);
            let known = 4.0 * a / s * (a / s).atan();
            assert!((irradiance(&square(a, h), DVec3::Z) - known).abs() < 1e-12 * known);
        }
        let sky = irradiance(&square(1e6, 1.0), DVec3::Z);
        assert!((sky - std::f64::consts::PI).abs() < 1e-5);
    }
}
