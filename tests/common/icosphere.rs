//! Displaced icospheres: closed meshes of 20·n² triangles, with bumps at several scales.

use std::collections::HashMap;

use glam::DVec3;

/// The displaced sphere with 20·n² triangles: radius 1, pushed out along its normal by a sum of waves whose
/// directions and phases come from `seed`. n = 71 gives 100,820 triangles, 224 gives 1,003,520.
pub fn icosphere(n: u32, seed: u64) -> Vec<[DVec3; 3]> {
    let waves = waves(seed);
    let displaced = |p: DVec3| {
        let p = p.normalize();
        let height: f64 = waves
            .iter()
            .map(|w| w.w * (w.truncate().dot(p) + w.w).sin())
            .sum();
        p * (1.0 + height)
    };
    // The same corner is met from up to six triangles and must be the same point each time.
    let mut corners = HashMap::new();
    let mut corner = |p: DVec3| {
        let key = p.to_array().map(|x| (x * 2f64.powi(40)).round() as i64);
        *corners.entry(key).or_insert_with(|| displaced(p))
    };
    let mut triangles = Vec::with_capacity(20 * (n * n) as usize);
    for [a, b, c] in icosahedron() {
        let at = |i: u32, j: u32| {
            (a * f64::from(n - i - j) + b * f64::from(i) + c * f64::from(j)) / f64::from(n)
        };
        for i in 0..n {
            for j in 0..n - i {
                let mut push = |t: [DVec3; 3]| triangles.push(t.map(&mut corner));
                push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                if i + j + 1 < n {
                    push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    triangles
}

/// Wave vector in xyz, amplitude in w: frequencies 3 to 48, each octave half as high as the one before.
fn waves(seed: u64) -> Vec<glam::DVec4> {
    let mut state = seed;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 * 2f64.powi(-52) - 1.0
    };
    (0..20)
        .map(|k| {
            let octave = f64::from(1 << (k / 4));
            let direction = DVec3::new(random(), random(), random()).normalize_or(DVec3::X);
            (direction * 3.0 * octave).extend(0.04 / octave)
        })
        .collect()
}

/// The twenty faces of the icosahedron with corners (0, ±1, ±φ) and their rotations, seen from outside
/// counter-clockwise.
fn icosahedron() -> Vec<[DVec3; 3]> {
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let mut corners = Vec::new();
    for (s, t) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let v = DVec3::new(0.0, s, t * phi);
        corners.extend([v, DVec3::new(v.z, v.x, v.y), DVec3::new(v.y, v.z, v.x)]);
    }
    // Neighbouring corners are 2 apart; no other two are nearer than 2φ.
    let near = |a: DVec3, b: DVec3| (a - b).length() < 2.5;
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                let [a, b, c] = [corners[i], corners[j], corners[k]];
                if near(a, b) && near(b, c) && near(c, a) {
                    let outward = (b - a).cross(c - a).dot(a) > 0.0;
                    faces.push(if outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    faces
}
