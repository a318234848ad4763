// The direction in which a light path starts: half of them about the light's normal, half at objects that gather light.
// Fills the slot <aim>.
// Twin of src/reference/integrator/bidirectional/aim.rs.
// uses: math/frame, math/steps, math/vec, bsdf/diffuse/lambert, light/sphere

// 1/pi: the cosine lobe's density over the cosine.
const float LOBE = 0.3183098861837907;

// A direction from the point p of a light with normal n: one in two within the cone of an aim, each as likely; `choice`
// and u are uniform. From inside a ball, and without aims, cos/pi.
vec3 aimed_direction(vec3 p, vec3 n, float choice, vec2 u) {
    uint place = uint(choice * float(2u * AIMS));
    vec3 d = to_world(frame_about(n), cosine_lobe(u));
    if (place < AIMS) {
        vec3 axis = aims[place].centre - p;
        float distance = length3(axis);
        if (distance > aims[place].radius) {
            float height = cone_height(aims[place].radius, distance);
            d = to_world(frame_about(axis / distance), cone_direction(height, u));
        }
    }
    return d;
}

// Density of that direction per solid angle, over its cosine at the light.
float aimed_density(vec3 p, vec3 d, float cosine) {
    float sum = 0.0;
    uint i = 0u;
    while (i < AIMS) {
        loop_steps += 1u;
        vec3 axis = aims[i].centre - p;
        float distance = length3(axis);
        float height = cone_height(aims[i].radius, distance);
        // 1 - cos = |d - axis|²/2, which loses no digit of a narrow cone.
        vec3 off = d - axis / distance;
        float cone = dot3(off, off) * 0.5 <= height ? cone_pdf(height) / cosine : 0.0;
        sum += distance > aims[i].radius ? cone : LOBE;
        i += 1u;
    }
    return AIMS == 0u ? LOBE : (LOBE + sum / float(AIMS)) * 0.5;
}
