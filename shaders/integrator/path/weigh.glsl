// Weight of light found by a connection, where only paths from the eye may find it. Fills the slot <weigh>.
// uses: path/vertex, light/sample, <connect>

float weigh(Subpath path, Vertex v, uint light, LightSample l, float p, float bsdf_pdf) {
    return connection_weight(p, bsdf_pdf);
}
