// A vertex of the path: what it emits, its connection to a light, and where the path goes on.
// uses: math/finite, path/vertex, path/flight, path/throughput, sampler/dimensions, sampler/unit_float, sampler/chance, <sampler>, <self_distance>, <background>, <emission>, <direct>, <bsdf>, <crossing>, <roulette>, <depth>, <medium>, <record>

void end_path(inout PathState s) {
    s.alive = 0u;
    s.ended = 1u;
}

// Draws the next direction and moves the path onto it; ends the path where there is none.
void extend(inout PathState s, Vertex v, inout FilmPixel pixel, uint pixel_index) {
    uint sample_index = job.sample_begin + s.index - 1u;
    uvec4 u = sampler_block(pixel_index, sample_index, bsdf_block(s.bounce), camera.seed);
    uvec4 w = sampler_block(pixel_index, sample_index, roulette_block(s.bounce), camera.seed);
    BsdfSample b = bsdf_sample(v.interaction, unit_float(u.x), unit_float(u.y),
                               vec2(unit_float(u.z), unit_float(u.w)), vec2(unit_float(w.y), unit_float(w.z)));
    vec3 wi = to_world(v.frame, b.wi);
    bool found = b.lobe != LOBE_NONE && same_sides(v, wi, b.wi);
    bool faint = underflows(s.throughput, b.weight);
    s.throughput *= b.weight;
    bool through = leads_through(b.wi);
    s.eta_scale *= crossing_scale(v, through);
    pixel.underflows += found && faint ? 1u : 0u;
    float survival = chance(roulette_survival(s.throughput, s.eta_scale, s.bounce));
    bool survives = unit_float(w.x) < survival;
    bool alive = found && survives && !(faint || is_black(s.throughput));
    s.throughput *= alive ? 1.0 / survival : 1.0;
    // A broken throughput breaks the sample, which the film then drops and counts.
    bool broken = !is_finite3(s.throughput);
    s.radiance += broken ? s.throughput : vec3(0.0);
    if (alive && !broken) {
        s.medium = medium_after(v, through, s.medium);
        bool goes_outside = v.outside != through;
        s.o = v.p;
        s.d = wi;
        s.shape = v.shape;
        s.prim = v.prim;
        s.start = goes_outside ? START_OUTSIDE : START_INSIDE;
        s.t_self = self_distance(v.shape, v.p, v.ng, wi);
        s.pdf = b.pdf;
        s.delta = b.lobe >= LOBE_DELTA ? 1u : 0u;
        s.bounce += 1u;
        pixel.long_paths += s.bounce == LONG_PATH ? 1u : 0u;
    } else {
        end_path(s);
    }
    record_vertex(s, v, b.lobe);
}

void shade(inout PathState s, Flight flight, inout FilmPixel pixel, uint pixel_index) {
    if (flight.hit.shape == NONE) {
        s.radiance += s.throughput * background_seen(s);
        record_escape(s);
        end_path(s);
    } else {
        Vertex v = path_vertex(flight.ray, flight.hit, flight.distance);
        record_hit(s, v);
        s.radiance += s.throughput * emission_seen(s, v, flight.origin, flight.distance);
        // A path sets out with some light: what has none has lost it to absorption.
        bool absorbed = is_black(s.throughput);
        pixel.underflows += absorbed ? 1u : 0u;
        if (materials[v.material].kind == KIND_BLACK || depth_reached(s.bounce) || absorbed) {
            record_vertex(s, v, LOBE_NONE);
            end_path(s);
        } else {
            connect(s, v, pixel_index);
            extend(s, v, pixel, pixel_index);
        }
    }
}
