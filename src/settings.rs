//! Settings of two kinds, kept apart: the model determines the picture that the renderer converges to, the estimator
//! only how fast (model.md, "Settings").

/// Reflectance of an interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fresnel {
    Schlick,
    Exact,
}

impl Fresnel {
    pub const EVERY: [Self; 2] = [Self::Schlick, Self::Exact];
}

/// Distribution of micro-normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Distribution {
    Phong,
    Beckmann,
    Ggx,
}

impl Distribution {
    pub const EVERY: [Self; 3] = [Self::Phong, Self::Beckmann, Self::Ggx];
}

/// The rule for a material's distribution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DistributionRule {
    /// The scene's own, [`DistributionRule::Auto`] if it has none.
    #[default]
    Scene,
    /// Phong for an exponent and GGX for a width, regardless of the scene.
    Auto,
    /// This one, regardless of the scene.
    Always(Distribution),
}

/// Where Beer's law is applied: on every stretch inside a medium, or only in E_t as the hand-out prints it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Absorption {
    Segment,
    Term,
}

/// How a lobe is chosen: by Fresnel's share, or by ‖Kd‖ : ‖Ks‖ : ‖Kt‖.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LobeChoice {
    Fresnel,
    Norms,
}

/// Density of sampled micro-normals: those visible from `wo`, or D(m)·(m·N).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Normals {
    Visible,
    Distribution,
}

/// Russian roulette.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roulette {
    /// Survival by the path's throughput, from the third bounce.
    Throughput,
    /// The same survival probability at every bounce, in (0, 1].
    Constant(f64),
    Off,
}

/// How light is found: explicit connections, paths that hit it, or both with multiple importance sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Connect {
    Mis,
    Light,
    Bsdf,
}

/// How the light that a vertex is connected to is picked: by its power, or by its contribution to the vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Lights {
    Contribution,
    Power,
}

/// The paths that find the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Integrator {
    /// Paths from the eye.
    Path,
    /// Paths from the lights, each vertex joined to the eye: they find light neither in mirrors nor through smooth
    /// glass, nor from the background.
    Light,
    /// Paths from both ends, joined at every pair of vertices.
    Bidirectional,
}

/// The random numbers of a pixel's samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Sampler {
    /// Independent ones.
    Random,
    /// Scrambled Sobol points, which are more evenly distributed.
    Sobol,
    /// The same in four mutually independent groups instead of two.
    SobolQuarters,
}

/// The model: the picture to converge to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    /// Overrides the scene's own words if given.
    pub fresnel: Option<Fresnel>,
    pub distribution: DistributionRule,
    pub absorption: Absorption,
    /// Factor eta² of radiance at each refraction.
    pub radiance_scaling: bool,
    /// Maximum number of bounces: 0 shows only emitters, 1 adds direct light; `None`: no limit.
    pub max_depth: Option<u32>,
}

/// The estimator: the speed of convergence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimator {
    pub integrator: Integrator,
    pub lobe: LobeChoice,
    pub normals: Normals,
    pub roulette: Roulette,
    pub connect: Connect,
    pub lights: Lights,
    pub sampler: Sampler,
}

/// All settings of one rendering.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    pub model: Model,
    pub estimator: Estimator,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            model: Model {
                fresnel: None,
                distribution: DistributionRule::Scene,
                absorption: Absorption::Segment,
                radiance_scaling: true,
                max_depth: None,
            },
            estimator: Estimator {
                integrator: Integrator::Path,
                lobe: LobeChoice::Fresnel,
                normals: Normals::Visible,
                roulette: Roulette::Throughput,
                connect: Connect::Mis,
                lights: Lights::Contribution,
                sampler: Sampler::Sobol,
            },
        }
    }
}

impl Settings {
    /// The model and the estimator of the course's hand-out.
    pub fn handout() -> Self {
        let mut s = Self::default();
        s.model.absorption = Absorption::Term;
        s.model.radiance_scaling = false;
        s.estimator.lobe = LobeChoice::Norms;
        s.estimator.normals = Normals::Distribution;
        s.estimator.roulette = Roulette::Constant(0.8);
        s.estimator.lights = Lights::Power;
        s.estimator.sampler = Sampler::Random;
        s
    }

    /// The settings under which a BSDF carries light from the light's side: f with its arguments swapped. Reflection is
    /// symmetric. Refraction is not: f(wi, wo) = eta² f(wo, wi) without radiance scaling, so the factor that scales
    /// radiance on paths from the eye is absent on paths from a light, and vice versa (model.md, "The adjoint"; Veach
    /// 1997, section 5.2).
    pub fn adjoint(mut self) -> Self {
        self.model.radiance_scaling = !self.model.radiance_scaling;
        self
    }
}
