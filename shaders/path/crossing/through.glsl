// The changes where a path crosses a surface. Fills the slot <crossing>.

// uses: constants/none, path/vertex, <scaling>

// Whether a direction in the frame of N' leads through the surface.
bool leads_through(vec3 wi) {
    return wi.z < 0.0;
}

// The factor that refraction has put into the throughput.
float crossing_scale(Vertex v, bool through) {
    return through ? transmission_scale(v.interaction.eta) : 1.0;
}

// The medium behind the surface: the shape's own on entering, air on leaving. Every object is in air.
uint medium_beyond(Vertex v) {
    return v.outside ? v.material : NONE;
}

// The medium in which the path continues, having come through `medium`.
uint medium_after(Vertex v, bool through, uint medium) {
    return through ? medium_beyond(v) : medium;
}
