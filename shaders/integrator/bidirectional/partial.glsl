// The densities of all techniques, as far as a subpath knows them, so that its vertices need not be visited again.
// Twin of src/reference/integrator/bidirectional/partial.rs, which has the formulas and their sources.

// uses: math/vec

// sqrt(dVCM) and sqrt(dVC) of a subpath.
struct Partial {
    // For the technique that joins the vertex before to the other side, over the subpath's own density.
    float vcm;
    // For all techniques that join still earlier vertices.
    float vc;
};

// A vertex at which two paths may meet, as the weights see it.
struct Junction {
    // |Ng.w| of the connection.
    float cosine;
    // Density per solid angle of the connection's direction, by the subpath that has come here.
    float pdf;
    // The same for the way back, by a path that came along the connection.
    float reverse_pdf;
};

// sqrt(a² + b²) of a, b >= 0, whose squares may overflow.
float hypot(float a, float b) {
    float most = max2(a, b);
    float least = min2(a, b);
    float ratio = least / (most > 0.0 ? most : 1.0);
    return most * sqrt(1.0 + ratio * ratio);
}

// Upper bound of every ratio: products of two are finite, and so is the weight of 0 to which they lead.
float bounded(float x) {
    return min2(x, 1e18);
}

// At the first vertex of a light path.
// dVCM = m(p_n c0/(p_e c1)), dVC = m(c0/p_e)/m(c1): the cosine c0 at the light cancels.
Partial from_light_point(float connection_pdf, float emission, float cosine) {
    float vc = bounded(1.0 / (emission * cosine));
    return Partial(bounded(connection_pdf * vc), vc);
}

// At the first vertex of an eye path: dVCM = m(n_l t²/(p_c c)), importance = p_c/(t² n_l).
Partial from_eye(float importance, float cosine) {
    return Partial(bounded(1.0 / (importance * cosine)), 0.0);
}

// At the next vertex, `distance` away: dVCM m(t²)/m(c), dVC/m(c).
Partial arrive(Partial at, float distance, float cosine) {
    return Partial(bounded(at.vcm * (distance * distance) / cosine), bounded(at.vc / cosine));
}

// sqrt(dVCM + dVC m(p_r))
float earlier(Partial at, float reverse_pdf) {
    return bounded(hypot(at.vcm, bounded(at.vc * reverse_pdf)));
}

// Along a direction that was drawn at a vertex: dVC = m(c/p)(dVC m(p_r) + dVCM), dVCM = m(1/p).
Partial scatter(Partial at, Junction to) {
    float back = earlier(at, to.reverse_pdf);
    return Partial(bounded(1.0 / to.pdf), bounded(to.cosine * back / to.pdf));
}

// Along a direction of a delta lobe: no connection joins its two ends, and p and p_r, two infinite densities, cancel.
Partial scatter_delta(Partial at, float cosine) {
    return Partial(0.0, cosine * at.vc);
}

// 1/(1 + a² + b²)
float weight(float a, float b) {
    return 1.0 / (1.0 + a * a + b * b);
}

// A light that an eye path hits: 1/(1 + m(p_n/p) + m(p_e/cos) dVC).
float hit_weight(Partial at, float connection_pdf, float emission) {
    return weight(bounded(connection_pdf * at.vcm), bounded(emission * at.vc));
}

// A light to which an eye path's vertex is connected:
// 1/(1 + m(p_b/p_n) + m(p_e c_x/(p_n c_l))(dVCM + dVC m(p_r))).
float light_weight(Partial at, Junction x, float connection_pdf, float emission) {
    float ratio = emission * x.cosine / connection_pdf;
    return weight(bounded(x.pdf / connection_pdf), bounded(ratio * earlier(at, x.reverse_pdf)));
}

// A light path's vertex joined to the eye: 1/(1 + m(p_c c/(t² n_l))(dVCM + dVC m(p_r))).
float splat_weight(Partial at, Junction y, float importance) {
    float ratio = importance * y.cosine;
    return weight(bounded(ratio * earlier(at, y.reverse_pdf)), 0.0);
}

// Two vertices joined, `distance` apart:
// 1/(1 + m(p_x c_y/d²)(dVCM_y + dVC_y m(p_r,y)) + m(p_y c_x/d²)(dVCM_x + dVC_x m(p_r,x))).
float vertex_weight(Partial eye, Junction x, Partial light, Junction y, float distance) {
    float square = distance * distance;
    float to_y = x.pdf * y.cosine / square;
    float to_x = y.pdf * x.cosine / square;
    return weight(bounded(to_y * earlier(light, y.reverse_pdf)), bounded(to_x * earlier(eye, x.reverse_pdf)));
}
