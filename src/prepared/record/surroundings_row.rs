//! A row of a picture of all directions.

crate::layout::record! {
    /// A row of texels, which have the same solid angle.
    pub struct SurroundingsRow<F> {
        /// Its upper edge. Between 45° and 135° from the upper pole cos θ, elsewhere sin²(θ/2), θ from the nearer pole:
        /// neither loses digits there.
        top: float,
        /// The same of its lower edge.
        bottom: float,
        /// The row's probability over a texel's solid angle, times 2⁻²⁴: the density per steradian for each of a texel's counts.
        pdf: float,
        /// Where the row's counts out of 2²⁴ end.
        end: uint,
    }
}
