//! Russian roulette (Arvo & Kirk, Particle Transport and Image Synthesis, SIGGRAPH 1990); twin of
//! `shaders/path/roulette/`.

pub use crate::layout::constants::path::LONG_PATH;
use crate::reference::math::{Real, Vec3, max_component, min2};
use crate::settings::Roulette;

/// Probability in (0, 1] that a path of this throughput continues after bounce number `bounce` (from 0).
///
/// By throughput: from the third bounce, with the radiance scale eta² divided out, because in glass of index n
/// throughput is n² smaller without being worth less.
pub fn roulette_survival<F: Real>(
    roulette: Roulette,
    throughput: Vec3<F>,
    eta_scale: F,
    bounce: u32,
) -> F {
    let survival = match roulette {
        Roulette::Throughput if bounce < 2 => F::one(),
        Roulette::Throughput => min2(F::one(), max_component(throughput) / eta_scale),
        Roulette::Constant(p) => F::new(p),
        Roulette::Off => F::one(),
    };
    long_path_survival(survival, bounce)
}

/// `survival`, at most .95 from bounce [`LONG_PATH`] on.
pub fn long_path_survival<F: Real>(survival: F, bounce: u32) -> F {
    if bounce >= LONG_PATH && survival > F::new(0.95) {
        F::new(0.95)
    } else {
        survival
    }
}
