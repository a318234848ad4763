//! Where kernel and reference differ by name, and why.

/// (start of a GLSL file, the Rust file with its twins): a file for a slot there is an arm of a `match` here,
/// or a function of the file that calls it; code that is generated there is written by hand here.
pub const HOMES: &[(&str, &str)] = &[
    // `mixed` with Kd = 0, to the bit
    ("bsdf/diffuse/absent", "bsdf/diffuse/mixed"),
    ("film/moments/quarters", "film/film_quarters"),
    ("film/moments", "film/film_moments"),
    ("generated", "bsdf/distribution"),
    ("generated", "bsdf/fresnel"),
    ("generated", "bsdf/kind"),
    ("generated", "bsdf/normals/visible"),
    ("generated", "world"),
    // the tables of the scene
    ("light/choice/", "world"),
    ("light/emission/point", "light/emission"),
    ("path/blocks/", "path/blocks"),
    ("path/correction/", "path/correction"),
    ("integrator/light/start/", "integrator/light/begin"),
    ("integrator/path/background/", "integrator/path"),
    ("path/crossing/", "path/vertex"),
    ("path/depth/", "path"),
    ("integrator/path/emission/", "integrator/path"),
    (
        "integrator/bidirectional/aim/",
        "integrator/bidirectional/aim",
    ),
    (
        "integrator/bidirectional/background/",
        "integrator/bidirectional/eye_path",
    ),
    (
        "integrator/bidirectional/direct/",
        "integrator/bidirectional/to_light",
    ),
    (
        "integrator/bidirectional/emission/",
        "integrator/bidirectional/eye_path",
    ),
    (
        "integrator/bidirectional/first/",
        "integrator/bidirectional/light_path",
    ),
    ("path/self_distance/", "path/vertex"),
    ("integrator/path/begin", "integrator/path"),
    ("integrator/path/shade", "integrator/path"),
    ("path/null_interface/", "path/trace"),
    ("path/valid/", "path/valid"),
    // there is a table or there is none: `Cover`
    ("shape/cover/", "shape/cover"),
    ("shape/face/", "shape/face"),
];

/// Kernel functions without a twin, by name or by the start of their file.
pub const KERNEL_ONLY: &[(&str, &str)] = &[
    ("film/moments/", "the buffer of moments, or none"),
    (
        "light/triangle_choice",
        "a mesh's part of one long table; cdf_choice and cdf_probability, given a slice",
    ),
    ("leads_through", "wi.z < 0"),
    ("surroundings_end", "reads a buffer, or several"),
    ("surroundings_value", "reads a buffer, or several"),
    ("no_candidate", "None"),
    ("crossing_scale", "an `if` in extend"),
    ("medium_after", "an `if` in spawn_ray"),
    (
        "path/trace",
        "traces a vertex's shadow ray one turn late, in one loop with the extension ray",
    ),
    ("integrator/path/record/", "the reference calls a Recorder"),
    (
        "integrator/bidirectional/record/",
        "the reference calls a Recorder",
    ),
    (
        "integrator/bidirectional/eye_rays",
        "traces a vertex's connections one turn late, in one loop with the extension ray",
    ),
    ("end_path", "a break"),
    ("join_all", "connections, but for their rays"),
    ("go_on", "the end of a turn in eye_path"),
    ("begin", "before the loop of a light path"),
    ("offer", "Reservoir::offer"),
    ("shade", "a turn of a path's loop"),
    ("keep_vertex", "writes a buffer"),
    ("kept_vertex", "reads a buffer"),
    ("kept_index", "a place in a buffer"),
    ("leave_pending", "the reference traces a connection at once"),
    ("weigh", "Weigh::weight"),
    ("coincidences_of", "Coincidences::of"),
    ("box_covered", CALLS_IS_COVERED),
    ("cylinder_covered", CALLS_IS_COVERED),
    ("mesh_covered", CALLS_IS_COVERED),
    ("sphere_covered", CALLS_IS_COVERED),
    ("shape/bvh/", "each renderer has a hierarchy of its own"),
    (
        "shape/normal/",
        "corner normals from a buffer; interpolated_normal has the arithmetic",
    ),
    ("shape/triangle/corner", "reads a buffer"),
];

const CALLS_IS_COVERED: &str = "is_covered, where faces of the kind coincide with others";

const PICTURE: &str = "the kernel has the picture and its tables in buffers";

const SAMPLE: &str = "the kernel has the sample's index in no SampleId";

/// Functions whose arguments differ.
pub const ARGUMENTS: &[(&str, &str)] = &[
    (
        "begin_path",
        "the kernel uses the state of the pixel's last path again",
    ),
    (
        "connect",
        "the kernel keeps the path apart from its state: naga takes no `inout` of a member",
    ),
    ("begin_light_path", SAMPLE),
    ("surroundings_texel", PICTURE),
    ("surroundings_radiance", PICTURE),
    ("surroundings_texel_pdf", PICTURE),
    ("surroundings_row", PICTURE),
    ("surroundings_column", PICTURE),
    ("surroundings_direction", PICTURE),
    ("surroundings_light_sample", PICTURE),
    ("surroundings_outside", PICTURE),
    ("outside_seen", "the kernel knows the background's index"),
    ("eye_drawn", SAMPLE),
    ("extend", SAMPLE),
    ("join_light", SAMPLE),
    ("light_start", SAMPLE),
    ("splat_light", SAMPLE),
    ("splat_vertex", SAMPLE),
    ("weighed_splat", SAMPLE),
    (
        "mesh_emission",
        "the place of the mesh's part of the table instead of a slice",
    ),
    (
        "first_partial",
        "the kernel has the light's point in its state",
    ),
    (
        "mesh_emission_pdf",
        "the place of the mesh's part of the table instead of a slice",
    ),
    (
        "go_on",
        "the kernel keeps the path apart from its state: naga takes no `inout` of a member",
    ),
    (
        "is_covered",
        "the kernel has the argument `asked`: an `if` around its loop crashes Mesa 22.3's compiler",
    ),
    (
        "is_origin",
        "the corners of a triangle instead of the triangle",
    ),
    (
        "mesh_light_pdf",
        "the place of the mesh's part of the table instead of a slice",
    ),
    (
        "mesh_light_sample",
        "the place of the mesh's part of the table instead of a slice",
    ),
    ("self_distance", "the kernel looks the kind of the shape up"),
    ("triangle_surface", "the kernel looks the triangle up"),
];

/// Free functions of the reference without a twin, by name or by the start of their file.
pub const REFERENCE_ONLY: &[(&str, &str)] = &[
    ("accel/", "each renderer has a hierarchy of its own"),
    ("film/film_join", "the host joins blocks of samples"),
    (
        "film_half_difference",
        "of the sums that the host reads back",
    ),
    (
        "integrator/layers",
        "layers are made by the reference alone, whatever device renders",
    ),
    ("film_stderr", "of the sums that the host reads back"),
    (
        "light/choice",
        "light_choice, light_pmf, triangle_choice and triangle_pmf, each over its part of a buffer",
    ),
    (
        "how",
        "which of the files of the slot <pick> the kernel contains",
    ),
    ("trace_bidirectional", "both kernels, one after the other"),
    ("begin_aimed_path", "a part of begin"),
    ("light_path", "the loop of light_trace.comp"),
    ("eye_path", "the loop of eye_trace.comp"),
    ("camera_ray", "the ray of the files of the slot <begin>"),
    ("arrives", "a part of trace_eye_rays"),
    (
        "connections",
        "join_all, and the rays that the kernel traces a turn late",
    ),
    ("sample_signature", "of what the host reads back"),
    ("brought", "of what the host reads back"),
    ("math/ulps", "measures errors; renders nothing"),
    ("path/trace", "the two halves of trace_rays"),
    ("shape/linear", "the loops that a kernel has written out"),
    ("arrived_splat", "a part of the loop of light_trace.comp"),
    ("trace_light", "the loop of light_trace.comp"),
    ("trace_path", "the loop of path_trace.comp"),
    ("vec3", "a constructor"),
];
