//! A row of a picture of all directions.

crate::layout::record! {
    /// A row of texels, all of the same solid angle.
    pub struct SurroundingsRow<F> {
        /// Its upper edge. Between 45° and 135° from the upper pole cos θ, elsewhere sin²(θ/2), θ from the nearer pole:
        /// neither loses digits there.
        top: float,
        /// The same for its lower edge.
        bottom: float,
        /// The row's probability divided by a texel's solid angle, times 2⁻²⁴: the density per steradian for each of a
        /// texel's counts.
        pdf: float,
        /// The end of the row's counts out of 2²⁴.
        end: uint,
    }
}
