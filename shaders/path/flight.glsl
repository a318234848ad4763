// The rays of one bounce: the pending shadow ray, then the extension ray.
// uses: math/steps, shape/ray, <nearest>, <medium>, <straight>, <record>

// Where the extension ray ended, how far it went from the last vertex, and that vertex.
struct Flight {
    Hit hit;
    Ray ray;
    float distance;
    vec3 origin;
};

const uint PHASE_SHADOW = 0u;
const uint PHASE_EXTEND = 1u;
const uint PHASE_DONE = 2u;

Flight fly(inout PathState s, inout FilmPixel pixel) {
    Flight flight;
    flight.origin = s.o;
    flight.distance = 0.0;
    uint phase = s.connecting != 0u ? PHASE_SHADOW : (s.alive != 0u ? PHASE_EXTEND : PHASE_DONE);
    while (phase != PHASE_DONE) {
        loop_steps += 1u;
        pixel.rays += 1u;
        Ray ray = Ray(s.o, s.d, s.shape, s.prim, s.start, s.t_self);
        float t_max = FAR;
        Target skip = Target(NONE, NONE);
        uint medium = s.medium;
        if (phase == PHASE_SHADOW) {
            ray = Ray(s.shadow_o, s.shadow_d, s.shadow_shape, s.shadow_prim, s.shadow_start, s.shadow_t_self);
            t_max = s.shadow_distance;
            skip = Target(s.target_shape, s.target_prim);
            medium = s.shadow_medium;
        }
        Hit hit = nearest(ray, t_max, skip);
        vec3 transmittance = stretch_transmittance(medium, hit.shape == NONE ? t_max : hit.t);
        if (goes_straight(hit)) {
            Passage passage = pass(ray, hit);
            if (phase == PHASE_SHADOW) {
                s.contribution *= transmittance * passage.factor;
                s.shadow_o = passage.o;
                s.shadow_shape = hit.shape;
                s.shadow_prim = hit.prim;
                s.shadow_start = passage.start;
                s.shadow_t_self = passage.t_self;
                s.shadow_distance = t_max - hit.t;
                s.shadow_medium = passage.medium;
            } else {
                s.throughput *= transmittance * passage.factor;
                s.o = passage.o;
                s.shape = hit.shape;
                s.prim = hit.prim;
                s.start = passage.start;
                s.t_self = passage.t_self;
                s.medium = passage.medium;
                flight.distance += hit.t;
            }
        } else if (phase == PHASE_SHADOW) {
            bool visible = hit.shape == NONE;
            s.contribution *= transmittance;
            s.radiance += visible ? s.contribution : vec3(0.0);
            record_connection(s, visible);
            s.connecting = 0u;
            phase = s.alive != 0u ? PHASE_EXTEND : PHASE_DONE;
        } else {
            s.throughput *= transmittance;
            flight.hit = hit;
            flight.ray = ray;
            flight.distance += hit.t;
            phase = PHASE_DONE;
        }
    }
    loop_failed = loop_failed || phase != PHASE_DONE;
    return flight;
}
