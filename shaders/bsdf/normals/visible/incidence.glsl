// The plane of incidence.
// Twin of src/reference/bsdf/normals/visible/incidence.rs.

// uses: math/vec

// The azimuth and inclination of wo.
struct Incidence {
    // Sine of the angle between wo and N'.
    float sine;
    // Its azimuth; 0 along N'.
    float cos_phi;
    float sin_phi;
};

// The plane of wo and N'.
Incidence incidence(vec3 wo) {
    float sine = sqrt(wo.x * wo.x + wo.y * wo.y);
    bool leans = sine > 0.0;
    return Incidence(sine, leans ? wo.x / sine : 1.0, leans ? wo.y / sine : 0.0);
}

// From (along the plane, across it, up) to the frame of N'.
vec3 incidence_to_frame(Incidence plane, vec3 v) {
    return vec3(v.x * plane.cos_phi - v.y * plane.sin_phi, v.x * plane.sin_phi + v.y * plane.cos_phi, v.z);
}

// And back.
vec3 incidence_from_frame(Incidence plane, vec3 v) {
    return vec3(v.x * plane.cos_phi + v.y * plane.sin_phi, v.y * plane.cos_phi - v.x * plane.sin_phi, v.z);
}

// u moved away from 0, where a Gaussian ends at infinity: at least the least nonzero uniform number.
float above_zero(float u) {
    return max2(u, 5.9604645e-8);
}
