//! The records that the path kernel keeps from one dispatch to the next, and what it is told at each.

crate::gpu_struct! {
    /// A path between two bounces, and the connection that its last vertex left pending.
    pub struct PathState {
        /// Origin of the next ray, scene units.
        o: vec3,
        /// Samples begun.
        index: uint,
        /// Its direction, of unit length.
        d: vec3,
        /// Which side of its shape it starts on.
        start: uint,
        /// The shape that it starts on, or NONE.
        shape: uint,
        prim: uint,
        /// The material that it travels in, or NONE.
        medium: uint,
        /// Bounces so far.
        bounce: uint,
        throughput: vec3,
        /// Product of the eta² in `throughput`.
        eta_scale: float,
        /// Of the sample under way, W·sr⁻¹·m⁻².
        radiance: vec3,
        /// Density of `d` per steradian.
        pdf: float,
        /// 1: there is a ray to extend.
        alive: uint,
        /// 1: the sample is complete but for its pending connection.
        ended: uint,
        /// 1: `d` comes from the camera or from a delta lobe.
        delta: uint,
        /// What the slot `record` keeps: events written down so far, or the chain of the path's vertices.
        recorded: uint,
        shadow_o: vec3,
        shadow_start: uint,
        shadow_d: vec3,
        shadow_distance: float,
        /// What the pending connection brings if nothing stands in its way.
        contribution: vec3,
        /// 1: a connection is pending.
        connecting: uint,
        shadow_shape: uint,
        shadow_prim: uint,
        shadow_medium: uint,
        target_shape: uint,
        target_prim: uint,
        /// Hits of the same mesh up to this distance may be rounding errors of `o`.
        t_self: float,
        /// The same for `shadow_o`.
        shadow_t_self: float,
        /// The same: the chain of its connections.
        connected: uint,
    }

    /// A pixel's sum of samples, Σ = sum + comp, and what was counted on the way.
    pub struct FilmPixel {
        sum: vec3,
        /// Samples complete.
        samples: uint,
        comp: vec3,
        rays: uint,
        /// Samples dropped for a NaN.
        nan: uint,
        /// Samples dropped for an infinity, or what adds up to one.
        infinite: uint,
        /// Loops that ended before their own end condition held.
        loops: uint,
        /// Paths that reached the bounce from which even lossless ones may end.
        long_paths: uint,
        /// Σ ± sample: + of the last, − of the one before, and so on by turns.
        contrast: vec3,
        /// Paths that ended because f32 holds no less throughput.
        underflows: uint,
    }

    /// What a pixel's samples x tell of the error of their mean, each sum in two parts as the film's is.
    pub struct FilmMoments {
        /// W·sr⁻¹·m⁻².
        mean: vec3,
        pad0: uint,
        mean_comp: vec3,
        pad1: uint,
        /// Σ (x − mean)².
        m2: vec3,
        pad2: uint,
        m2_comp: vec3,
        pad3: uint,
    }

    /// An event of a path, written down for `--trace`.
    pub struct Record {
        /// RECORD_VERTEX, RECORD_CONNECTION or RECORD_ESCAPE.
        event: uint,
        /// The vertex's lobe; whether the connection arrived.
        lobe: uint,
        /// Of the vertex, or of the light connected to.
        shape: uint,
        prim: uint,
        /// The vertex; the direction of the connection or of the escape.
        p: vec3,
        /// Density of the next direction.
        pdf: float,
        /// After the vertex; what the connection brought, or as much of it as reached what blocks it.
        throughput: vec3,
        /// Material that the path goes on in.
        medium: uint,
        /// Of the sample so far, pending connection not counted.
        radiance: vec3,
        pad0: uint,
    }

    /// What one sample came to, kept for `compare --paired`.
    pub struct PathOutcome {
        /// W·sr⁻¹·m⁻².
        radiance: vec3,
        /// The hash of the path's decisions, see `reference::path::signature`.
        signature: uint,
    }

    /// What one dispatch is to do.
    pub struct Slice {
        /// The tile, in pixels from the top left of the full picture.
        tile_x: uint,
        tile_y: uint,
        tile_width: uint,
        tile_height: uint,
        /// Index of the sample that counts as number 0 of this rendering.
        sample_begin: uint,
        /// Each pixel is to have this many samples.
        sample_end: uint,
        /// Loop steps after which a thread hands its path over to the next dispatch.
        budget: uint,
        /// Material that the eye stands in, or NONE.
        eye_medium: uint,
    }
}
