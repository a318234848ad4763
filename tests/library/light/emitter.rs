//! Emitters of every kind, as seen from somewhere: sampled, and hit.

use glam::DVec3;
use vkpt::prepared::cdf::quantised_cdf;
use vkpt::reference::light::{
    LightSample, background_light_pdf, background_light_sample, box_light_pdf, box_light_sample,
    cylinder_light_pdf, cylinder_light_sample, mesh_light_pdf, mesh_light_sample, sphere_light_pdf,
    sphere_light_sample,
};
use vkpt::reference::math::frame::frame_about;
use vkpt::reference::math::{Real, Vec3, dot3};
use vkpt::reference::shape::triangle::area::triangle_area;
use vkpt::reference::shape::{
    Cuboid, Cylinder, Hit, Ray, START_ELSEWHERE, Sphere, Triangle, box_hit, box_surface,
    cylinder_hit, cylinder_surface, ray_shear, sphere_hit, sphere_surface, triangle_hit,
};

use crate::shape::random::Random;

#[derive(Clone, Debug)]
pub enum Emitter<F> {
    Sphere(Sphere<F>),
    Box(Cuboid<F>),
    Cylinder(Cylinder<F>),
    Mesh(Vec<Triangle<F>>, Vec<u32>),
    Background,
}

/// A point of an emitter on a line of sight: its distance, |N·w|, and the density of the direction to it.
pub struct Sight<F> {
    pub distance: F,
    pub cosine: F,
    pub pdf: F,
}

impl<F: Real> Emitter<F> {
    pub fn sphere(centre: DVec3, radius: f64) -> Self {
        Self::Sphere(Sphere {
            centre: Vec3::new(centre),
            radius: F::new(radius),
            shape: 0,
        })
    }

    pub fn cuboid(lo: DVec3, hi: DVec3) -> Self {
        Self::Box(Cuboid {
            lo: Vec3::new(lo),
            hi: Vec3::new(hi),
            shape: 0,
        })
    }

    pub fn cylinder(base: DVec3, axis: DVec3, radius: f64) -> Self {
        let frame = frame_about(Vec3::<f64>::new(axis.normalize()));
        Self::Cylinder(Cylinder {
            base: Vec3::new(base),
            u: Vec3::new(frame.t.f64()),
            v: Vec3::new(frame.b.f64()),
            w: Vec3::new(frame.n.f64()),
            height: F::new(axis.length()),
            radius: F::new(radius),
            shape: 0,
        })
    }

    pub fn mesh(triangles: &[[DVec3; 3]]) -> Self {
        let area = |t: &[DVec3; 3]| 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).length();
        let areas: Vec<f64> = triangles.iter().map(area).collect();
        let triangles = triangles.iter().map(|t| Triangle {
            v: t.map(Vec3::new),
            shape: 0,
        });
        Self::Mesh(triangles.collect(), quantised_cdf(&areas).expect("areas"))
    }

    pub fn sample(&self, p: Vec3<F>, random: &mut Random) -> LightSample<F> {
        let u24 = (random.bits() >> 40) as u32;
        self.sample_at(p, u24, [F::new(random.unit()), F::new(random.unit())])
    }

    pub fn sample_at(&self, p: Vec3<F>, u24: u32, u: [F; 2]) -> LightSample<F> {
        match self {
            Self::Sphere(s) => sphere_light_sample(p, s.centre, s.radius, u),
            Self::Box(b) => box_light_sample(p, b.lo, b.hi, u24, u),
            Self::Cylinder(c) => cylinder_light_sample(p, c, u24, u),
            Self::Mesh(triangles, cdf) => mesh_light_sample(p, triangles, 0, cdf, u24, u),
            Self::Background => background_light_sample(u),
        }
    }

    /// The hits along a line of sight: the first point of a solid, every triangle of a mesh.
    pub fn sights(&self, p: Vec3<F>, d: Vec3<F>) -> Vec<Sight<F>> {
        let ray = Ray::new(p, d);
        let hit = |t: F, prim: u32| Hit {
            t,
            shape: 0,
            prim,
            uv: [F::zero(); 2],
        };
        let sight = |distance: F, ng: Vec3<F>, pdf: &dyn Fn(F, F) -> F| {
            let cosine = dot3(ng, d).abs();
            let pdf = pdf(distance, cosine);
            Sight {
                distance,
                cosine,
                pdf,
            }
        };
        let mut all = match self {
            Self::Sphere(s) => {
                let t = sphere_hit(p, d, s.centre, s.radius, START_ELSEWHERE);
                let ng = sphere_surface(ray, hit(t, 0), s).ng;
                vec![sight(t, ng, &|t, c| {
                    sphere_light_pdf(p, s.centre, s.radius, t, c)
                })]
            }
            Self::Box(b) => {
                let h = box_hit(p, d, b.lo, b.hi, START_ELSEWHERE);
                let ng = box_surface(ray, hit(h.t, h.face), b).ng;
                vec![sight(h.t, ng, &|t, c| box_light_pdf(p, b.lo, b.hi, t, c))]
            }
            Self::Cylinder(cylinder) => {
                let h = cylinder_hit(p, d, cylinder, START_ELSEWHERE, 0);
                let ng = cylinder_surface(ray, hit(h.t, h.part), cylinder).ng;
                vec![sight(h.t, ng, &|t, c| {
                    cylinder_light_pdf(p, cylinder, t, c)
                })]
            }
            Self::Mesh(triangles, cdf) => {
                let shear = ray_shear(d);
                let one = |(prim, triangle): (usize, &Triangle<F>)| {
                    let [a, b, c] = triangle.v;
                    let t = triangle_hit(p, shear, a, b, c).t;
                    let pdf = |t, c| mesh_light_pdf(triangles, 0, cdf, prim as u32, t, c);
                    sight(t, triangle_area(a, b, c).ng, &pdf)
                };
                triangles.iter().enumerate().map(one).collect()
            }
            Self::Background => vec![Sight {
                distance: F::one(),
                cosine: F::one(),
                pdf: background_light_pdf(),
            }],
        };
        all.retain(|s| s.distance > F::zero());
        all
    }

    /// The density of a direction.
    pub fn pdf(&self, p: Vec3<F>, d: Vec3<F>) -> F {
        self.sights(p, d)
            .iter()
            .fold(F::zero(), |sum, s| sum + s.pdf)
    }
}

/// A tetrahedron of unequal faces.
pub fn tetrahedron() -> Vec<[DVec3; 3]> {
    let v = [
        DVec3::new(0.0, 0.0, 0.0),
        DVec3::new(1.0, 0.1, 0.0),
        DVec3::new(0.2, 0.7, 0.1),
        DVec3::new(0.3, 0.2, 1.5),
    ];
    vec![
        [v[0], v[2], v[1]],
        [v[0], v[1], v[3]],
        [v[1], v[2], v[3]],
        [v[2], v[0], v[3]],
    ]
}
