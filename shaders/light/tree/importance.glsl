// The importance of a node of lights at a point.
// Twin of src/reference/light/tree/importance.rs.
// uses: math/vec

// cos(max(0, a - b)) of two angles of [0, pi], each given by cosine and sine.
float cos_beyond(float cos_a, float sin_a, float cos_b, float sin_b) {
    float beyond = cos_a * cos_b + sin_a * sin_b;
    return cos_a > cos_b ? 1.0 : beyond;
}

// sin(max(0, a - b))
float sin_beyond(float cos_a, float sin_a, float cos_b, float sin_b) {
    float beyond = sin_a * cos_b - cos_a * sin_b;
    return cos_a > cos_b ? 0.0 : beyond;
}

// The sine of an angle of [0, pi].
float sine_of(float cosine) {
    return sqrt(max2(1.0 - cosine * cosine, 0.0));
}

// power cos(theta') cos(theta_i')/d^2: an estimate of the light from the node's lights at p (Conty Estevez & Kulla, Importance
// Sampling of Many Lights with Adaptive Tree Splitting, HPG 2018, section 5.1; pbrt 4, section 12.6.3). The ball is seen under the
// angle theta_b; theta' = max(0, theta - theta_o - theta_b) is the least angle of any normal of the cone to p, theta_i' =
// max(0, theta_i - theta_b) the least angle of n to the ball. Emitters emit on both sides, so cos theta counts without its sign.
// From inside the ball, d is r and the angles give no bound. n = 0: the point is lit from both sides. `power` is a share of the
// scene's: radiance times the area seen from afar, summed over the node's lights and RGB.
float node_importance(LightNode node, vec3 p, vec3 n) {
    vec3 to = node.centre - p;
    float r2 = node.radius * node.radius;
    float d2 = dot3(to, to);
    float outside = d2 > r2 ? 1.0 : 0.0;
    vec3 w = to * (1.0 / sqrt(outside > 0.0 ? d2 : 1.0));
    float sin_b = sqrt(outside > 0.0 ? r2 / d2 : 1.0);
    float cos_b = outside > 0.0 ? sqrt(1.0 - sin_b * sin_b) : -1.0;
    float cos_w = abs(dot3(node.axis, w));
    float cos_x = cos_beyond(cos_w, sine_of(cos_w), node.cos_o, node.sin_o);
    float sin_x = sin_beyond(cos_w, sine_of(cos_w), node.cos_o, node.sin_o);
    float emitted = cos_beyond(cos_x, sin_x, cos_b, sin_b);
    float cos_i = dot3(n, w);
    float received = max2(cos_beyond(cos_i, sine_of(cos_i), cos_b, sin_b), 0.0);
    bool one_sided = dot3(n, n) > 0.0;
    float cosines = emitted * (one_sided ? received : 1.0);
    return node.power / max2(d2, r2) * (outside > 0.0 ? cosines : 1.0);
}
