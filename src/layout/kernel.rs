//! The records that the path kernel keeps from one dispatch to the next, and what it is told at each.

crate::gpu_struct! {
    /// The half-line o + t d, 0 < t < t_max, what it starts on and what it travels in.
    pub struct Ray {
        /// Rendering space.
        o: vec3,
        /// FAR where nothing limits it.
        t_max: float,
        /// Unit length.
        d: vec3,
        /// The shape that it starts on, or NONE.
        shape: uint,
        /// The primitive that it starts on, as in Hit, or NONE.
        prim: uint,
        /// Which side of its shape it leaves to: START_…
        start: uint,
        /// How far the origin's rounding error reaches along the ray, where it starts on a mesh; else 0.
        t_self: float,
        /// The material that it travels in, or NONE.
        medium: uint,
    }

    /// A connection under way.
    pub struct ShadowRay {
        /// Ends at the point.
        ray: Ray,
        /// What arrives if nothing stands in its way.
        contribution: vec3,
        /// 1: it has still to be traced.
        pending: uint,
        /// The shape, and the face of it, that the ray leads to: they do not stop the ray.
        target_shape: uint,
        target_prim: uint,
        /// The medium that a connection of two vertices must arrive in.
        medium: uint,
        pad0: uint,
    }

    /// What carries over from one vertex of a path to the next, whichever end it began at.
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

    /// A thread of path tracing between two bounces: the path, and the connection that its last vertex left pending.
    pub struct PathState {
        path: Subpath,
        shadow: ShadowRay,
        /// Of the sample under way, W·sr⁻¹·m⁻².
        radiance: vec3,
        /// 1: the sample is complete but for its pending connection.
        ended: uint,
        /// What the slot `pick` asks of the path's last vertex; 0 where it asks nothing.
        pick_normal: vec3,
        /// What the slot `record` keeps: events written down so far, or the chain of the path's vertices.
        recorded: uint,
        /// The same: the chain of its connections.
        connected: uint,
        pad0: uint,
        pad1: uint,
        pad2: uint,
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
        /// The brightest channel of all samples, W·sr⁻¹·m⁻².
        largest: float,
        /// The index of the first sample that has it.
        largest_sample: uint,
        pad0: uint,
        pad1: uint,
    }

    /// Of a pixel's samples.
    pub struct FilmQuarters {
        /// Σ ± sample of even index, W·sr⁻¹·m⁻².
        even: vec3,
        pad0: uint,
        /// Of odd index.
        odd: vec3,
        pad1: uint,
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
        /// The hash of the path's decisions, see `reference::integrator::path::signature`.
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

    /// A thread of light tracing between two dispatches.
    pub struct LightState {
        path: Subpath,
        shadow: ShadowRay,
        /// L cos/p_e of the path's first vertex.
        power: vec3,
        /// Light paths begun, from the first sample on.
        index: uint,
        /// The pixel, and the sample index, that the pending connection belongs to.
        pixel: uint,
        splat_sample: uint,
        /// What the weights of bidirectional paths know along the path's ray: √dVCM and √dVC.
        vcm: float,
        vc: float,
        /// Of the light path's first vertex: P p_A p/cos, the cosine of its ray, its light and the face of that.
        emission: float,
        light_cosine: float,
        light: uint,
        light_prim: uint,
    }

    /// A thread of the eye's side of bidirectional path tracing between two bounces: the path, and the connections that its last
    /// vertex left pending.
    pub struct EyeState {
        path: Subpath,
        to_light: ShadowRay,
        /// To the kept vertices of the light path.
        to_first: ShadowRay,
        to_second: ShadowRay,
        /// Of the sample under way, W·sr⁻¹·m⁻².
        radiance: vec3,
        /// 1: the sample is complete but for its pending connections.
        ended: uint,
        /// What the slot `pick` asks of the path's last vertex; 0 where it asks nothing.
        pick_normal: vec3,
        /// The sample index after the last complete one.
        done: uint,
        /// What the weights know along the path's ray: √dVCM and √dVC.
        vcm: float,
        vc: float,
        /// What the slot `record` keeps: the chains of the path's vertices and of its connections.
        recorded: uint,
        connected: uint,
    }

    /// How many vertices of a light path could have been kept.
    pub struct Reservoir {
        seen: uint,
        /// What the slot `record` keeps: the chain of the light path's vertices.
        decided: uint,
        pad0: uint,
        pad1: uint,
    }

    /// What the eye path of a sample has brought.
    pub struct Radiance {
        /// W·sr⁻¹·m⁻².
        value: vec3,
        /// The hash of its decisions, where it is kept: see `reference::integrator::bidirectional::signature`.
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
        /// The medium that the path came through.
        medium: uint,
        /// Whence the path came, of unit length.
        wo: vec3,
        /// Vertices of the path up to this one, the light's own among them.
        count: uint,
        /// Power that arrives, W.
        power: vec3,
        pad0: uint,
        /// What the weights know: √dVCM and √dVC.
        vcm: float,
        vc: float,
        pad1: uint,
        pad2: uint,
    }

    /// What a thread of light tracing, or of the eye's side of bidirectional path tracing, did in one dispatch.
    pub struct LightLane {
        /// Slots filled.
        splats: uint,
        /// 1: there are light paths to go on with.
        unfinished: uint,
        rays: uint,
        /// Loops that ended before their own end condition held.
        loops: uint,
        /// Paths that reached the bounce from which even lossless ones may end.
        long_paths: uint,
        /// Paths that ended because f32 holds no less throughput.
        underflows: uint,
        /// Paths that ended because their throughput was NaN.
        nan: uint,
        /// The same, infinite.
        infinite: uint,
    }

    /// Light that arrived at a pixel.
    pub struct Splat {
        /// What it adds to the pixel's mean of one sample index, W·sr⁻¹·m⁻².
        value: vec3,
        /// row · width + column of the full picture.
        pixel: uint,
        /// The sample index of its light path.
        index: uint,
        pad0: uint,
        pad1: uint,
        pad2: uint,
    }

    /// What one dispatch of light tracing is to do.
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
        /// Loop steps after which a thread hands its path over to the next dispatch.
        budget: uint,
        /// Material that the eye stands in, or NONE.
        eye_medium: uint,
    }
}
