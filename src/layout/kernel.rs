//! The records that the path kernel keeps from one dispatch to the next, and the parameters of each dispatch.

crate::gpu_struct! {
    /// The half-line o + t d, 0 < t < t_max, with its start and medium.
    pub struct Ray {
        /// Rendering space.
        o: vec3,
        /// FAR if nothing limits it.
        t_max: float,
        /// Unit length.
        d: vec3,
        /// The shape that it starts on, or NONE.
        shape: uint,
        /// The primitive that it starts on, as in Hit, or NONE.
        prim: uint,
        /// Which side of its shape it leaves to: START_…
        start: uint,
        /// How far the origin's rounding error reaches along the ray, if it starts on a mesh; else 0.
        t_self: float,
        /// The material that it travels in, or NONE.
        medium: uint,
    }

    /// A pending connection.
    pub struct ShadowRay {
        /// Ends at the point.
        ray: Ray,
        /// The contribution if nothing blocks the ray.
        contribution: vec3,
        /// 1: still to be traced.
        pending: uint,
        /// The shape and face that the ray aims at: they do not block it.
        target_shape: uint,
        target_prim: uint,
        /// The medium that a connection of two vertices must arrive in.
        medium: uint,
        pad0: uint,
    }

    /// The state carried from one vertex of an eye path or light path to the next.
    pub struct Subpath {
        /// The next ray.
        ray: Ray,
        throughput: vec3,
        /// Product of the eta² in `throughput`.
        eta_scale: float,
        /// Density of the ray's direction per steradian.
        pdf: float,
        /// 1: the direction comes from the camera or from a delta lobe.
        delta: uint,
        /// Bounces so far.
        bounce: uint,
        /// 1: there is a ray to extend.
        alive: uint,
    }

    /// A thread of path tracing between two bounces: the path, and the pending connection of its last vertex.
    pub struct PathState {
        path: Subpath,
        shadow: ShadowRay,
        /// Of the current sample, W·sr⁻¹·m⁻².
        radiance: vec3,
        /// 1: the sample is complete but for its pending connection.
        ended: uint,
        /// Data of the slot `pick` about the path's last vertex; 0 if it needs none.
        pick_normal: vec3,
        /// Data of the slot `record`: the number of events recorded so far, or the chain of the path's vertices.
        recorded: uint,
        /// Data of the slot `record`: the chain of the path's connections.
        connected: uint,
        pad0: uint,
        pad1: uint,
        pad2: uint,
    }

    /// A pixel's sum of samples, Σ = sum + comp, and its counters.
    pub struct FilmPixel {
        sum: vec3,
        /// Complete samples.
        samples: uint,
        comp: vec3,
        rays: uint,
        /// Samples dropped because of a NaN.
        nan: uint,
        /// Samples dropped because they are infinite, or so large that a sum of them could overflow.
        infinite: uint,
        /// Loops cut off before their own end condition was met.
        loops: uint,
        /// Paths that reached the bounce from which even lossless ones may end.
        long_paths: uint,
        /// Σ ± sample with alternating signs: + for the last, − for the one before, and so on.
        contrast: vec3,
        /// Paths that ended because their throughput underflowed f32.
        underflows: uint,
        /// The brightest channel of all samples, W·sr⁻¹·m⁻².
        largest: float,
        /// The index of the first sample with this value.
        largest_sample: uint,
        pad0: uint,
        pad1: uint,
    }

    /// Sums over a pixel's samples.
    pub struct FilmQuarters {
        /// Σ ± sample of even index, W·sr⁻¹·m⁻².
        even: vec3,
        pad0: uint,
        /// The same for odd indices.
        odd: vec3,
        pad1: uint,
    }

    /// Moments of a pixel's samples x, for the error of their mean; each sum is in two parts, as in the film.
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

    /// An event of a path, recorded for `--trace`.
    pub struct Record {
        /// RECORD_VERTEX, RECORD_CONNECTION or RECORD_ESCAPE.
        event: uint,
        /// The vertex's lobe; whether the connection arrived.
        lobe: uint,
        /// The shape of the vertex, or of the light connected to.
        shape: uint,
        prim: uint,
        /// Position of the vertex; direction of the connection or of the escape.
        p: vec3,
        /// Density of the next direction.
        pdf: float,
        /// After the vertex; the contribution of the connection, up to the surface that blocks it, if any.
        throughput: vec3,
        /// Material that the path continues in.
        medium: uint,
        /// Of the sample so far, without the pending connection.
        radiance: vec3,
        pad0: uint,
    }

    /// The result of one sample, kept for `compare --paired`.
    pub struct PathOutcome {
        /// W·sr⁻¹·m⁻².
        radiance: vec3,
        /// The hash of the path's decisions, see `reference::integrator::path::signature`.
        signature: uint,
    }

    /// The task of one dispatch.
    pub struct Slice {
        /// The tile, in pixels from the top left of the full picture.
        tile_x: uint,
        tile_y: uint,
        tile_width: uint,
        tile_height: uint,
        /// Index of the sample that counts as number 0 in this rendering.
        sample_begin: uint,
        /// The number of samples of each pixel after this slice.
        sample_end: uint,
        /// Loop steps after which a thread saves its path for the next dispatch.
        budget: uint,
        /// Material that surrounds the eye, or NONE.
        eye_medium: uint,
    }

    /// A thread of light tracing between two dispatches.
    pub struct LightState {
        path: Subpath,
        shadow: ShadowRay,
        /// L cos/p_e of the path's first vertex.
        power: vec3,
        /// Light paths begun, from the first sample on.
        index: uint,
        /// The pixel and sample index of the pending connection.
        pixel: uint,
        splat_sample: uint,
        /// State of the weights of bidirectional paths along the path's ray: √dVCM and √dVC.
        vcm: float,
        vc: float,
        /// For the light path's first vertex: P p_A p/cos, the cosine of its ray, its light, and the face of the light.
        emission: float,
        light_cosine: float,
        light: uint,
        light_prim: uint,
    }

    /// A thread of the eye's side of bidirectional path tracing between two bounces: the path, and the pending
    /// connections of its last vertex.
    pub struct EyeState {
        path: Subpath,
        to_light: ShadowRay,
        /// To the kept vertices of the light path.
        to_first: ShadowRay,
        to_second: ShadowRay,
        /// Of the current sample, W·sr⁻¹·m⁻².
        radiance: vec3,
        /// 1: the sample is complete but for its pending connections.
        ended: uint,
        /// Data of the slot `pick` about the path's last vertex; 0 if it needs none.
        pick_normal: vec3,
        /// The sample index after the last complete one.
        done: uint,
        /// State of the weights along the path's ray: √dVCM and √dVC.
        vcm: float,
        vc: float,
        /// Data of the slot `record`: the chains of the path's vertices and of its connections.
        recorded: uint,
        connected: uint,
    }

    /// The number of vertices of a light path that could have been kept.
    pub struct Reservoir {
        seen: uint,
        /// Data of the slot `record`: the chain of the light path's vertices.
        decided: uint,
        pad0: uint,
        pad1: uint,
    }

    /// The contribution of the eye path of a sample.
    pub struct Radiance {
        /// W·sr⁻¹·m⁻².
        value: vec3,
        /// The hash of its decisions, if requested: see `reference::integrator::bidirectional::signature`.
        signature: uint,
    }

    /// A vertex of a light path, kept for the eye path of the same sample.
    pub struct LightVertex {
        p: vec3,
        shape: uint,
        /// Outward geometric normal.
        ng: vec3,
        prim: uint,
        /// Shading normal on its side.
        ns: vec3,
        /// The medium that the path arrived through.
        medium: uint,
        /// Direction back along the path, unit length.
        wo: vec3,
        /// Vertices of the path up to this one, including the one on the light.
        count: uint,
        /// Arriving power, W.
        power: vec3,
        pad0: uint,
        /// State of the weights: √dVCM and √dVC.
        vcm: float,
        vc: float,
        pad1: uint,
        pad2: uint,
    }

    /// The results of one dispatch for a thread of light tracing, or of the eye's side of bidirectional path tracing.
    pub struct LightLane {
        /// Slots filled.
        splats: uint,
        /// 1: some light paths are not finished.
        unfinished: uint,
        rays: uint,
        /// Loops cut off before their own end condition was met.
        loops: uint,
        /// Paths that reached the bounce from which even lossless ones may end.
        long_paths: uint,
        /// Paths that ended because their throughput underflowed f32.
        underflows: uint,
        /// Paths that ended because their throughput was NaN.
        nan: uint,
        /// The same for infinity.
        infinite: uint,
    }

    /// Light that arrived at a pixel.
    pub struct Splat {
        /// Its contribution to the pixel's mean of one sample index, W·sr⁻¹·m⁻².
        value: vec3,
        /// row · width + column of the full picture.
        pixel: uint,
        /// The sample index of its light path.
        index: uint,
        pad0: uint,
        pad1: uint,
        pad2: uint,
    }

    /// The task of one dispatch of light tracing.
    pub struct LightSlice {
        /// The light paths: a rectangle of pixels from the top left of the full picture.
        tile_x: uint,
        tile_y: uint,
        tile_width: uint,
        tile_height: uint,
        /// The pixels that are rendered.
        film_x: uint,
        film_y: uint,
        film_width: uint,
        film_height: uint,
        /// The sample indices of this pass.
        sample_begin: uint,
        sample_end: uint,
        /// Loop steps after which a thread saves its path for the next dispatch.
        budget: uint,
        /// Material that surrounds the eye, or NONE.
        eye_medium: uint,
    }
}
