// No surface transmits light: no path crosses one. Fills the slot <crossing>.

// uses: path/vertex

bool leads_through(vec3 wi) {
    return false;
}

float crossing_scale(Vertex v, bool through) {
    return 1.0;
}

uint medium_after(Vertex v, bool through, uint medium) {
    return medium;
}
