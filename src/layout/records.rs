//! The records of a scene, as host and kernel share them.

crate::gpu_struct! {
    /// A material, with all that depends on it alone. Pairs hold the outer side first; see `prepared::Material`.
    pub struct Material {
        /// Diffuse reflectance.
        kd: vec3,
        /// Mean of kd over RGB.
        kd_mean: float,
        /// Reflectance at normal incidence for Schlick.
        f0: vec3,
        /// Parameter of the distribution: width, or Phong's exponent.
        alpha: float,
        /// −ln Kt per scene unit.
        sigma: vec3,
        /// Width; for Phong √(2/(exponent + 2)).
        width: float,
        /// Emitted radiance, W·sr⁻¹·m⁻².
        radiance: vec3,
        /// Probability of the diffuse lobe by norms.
        p_d: float,
        /// n_o / n_i for wo outside, inside.
        eta: vec2,
        /// 1 − eta².
        one_minus_eta2: vec2,
        /// (n_i / n_o)² − 1.
        d: vec2,
        /// Probability of reflection by norms, once the micro-normal is drawn.
        p_r: float,
        /// `prepared::MaterialKind`.
        kind: uint,
        /// `settings::Distribution`.
        distribution: uint,
        /// `settings::Fresnel`.
        fresnel: uint,
        pad0: uint,
        pad1: uint,
    }

    /// A ball: { p : |p − centre| ≤ radius }.
    pub struct Sphere {
        /// Scene units.
        centre: vec3,
        /// Scene units.
        radius: float,
        /// Index of its shape.
        shape: uint,
        pad0: uint,
        pad1: uint,
        pad2: uint,
    }

    /// An axis-aligned box: { p : lo ≤ p ≤ hi }.
    pub struct Cuboid {
        /// Scene units.
        lo: vec3,
        /// Index of its shape.
        shape: uint,
        /// Scene units.
        hi: vec3,
        pad0: uint,
    }

    /// The solid { base + x u + y v + z w : x² + y² ≤ radius², 0 ≤ z ≤ height }, (u, v, w) orthonormal.
    pub struct Cylinder {
        /// Centre of the base disc, scene units.
        base: vec3,
        /// Scene units.
        height: float,
        u: vec3,
        /// Scene units.
        radius: float,
        v: vec3,
        /// Index of its shape.
        shape: uint,
        /// Axis.
        w: vec3,
        pad0: float,
    }

    /// A solid or a mesh.
    pub struct Shape {
        /// `prepared::ShapeKind`.
        kind: uint,
        /// First primitive, an index into the array of its kind.
        first: uint,
        /// Number of primitives.
        count: uint,
        /// Index.
        material: uint,
        /// Index, or NONE.
        light: uint,
        pad0: uint,
        pad1: uint,
        pad2: uint,
    }

    /// An emitter that is sampled explicitly.
    pub struct Light {
        /// W·sr⁻¹·m⁻².
        radiance: vec3,
        /// `prepared::LightKind`.
        kind: uint,
        /// Index of its shape, or NONE for the background.
        shape: uint,
        /// First primitive, an index into the array of its kind.
        first: uint,
        /// Number of primitives.
        count: uint,
        /// A mesh's first entry in the table that chooses a triangle.
        cdf: uint,
    }

    /// A pinhole: the point (x, y) of the picture plane is seen along forward + x right + y up.
    pub struct Camera {
        /// Scene units.
        eye: vec3,
        /// Pixels.
        width: uint,
        /// Length tan(fov_y / 2) · width / height.
        right: vec3,
        /// Pixels.
        height: uint,
        /// Length tan(fov_y / 2).
        up: vec3,
        /// Of the sampler.
        seed: uint,
        /// Unit length.
        forward: vec3,
        pad0: uint,
    }
}
