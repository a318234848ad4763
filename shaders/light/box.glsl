// Axis-aligned boxes as lights.
// Twin of src/reference/light/box.rs.

// uses: math/vec, light/sample

// The number of faces across each axis that are sampled from p, 0 to 2: from outside those that show their front, at
// most one an axis; from inside, or from a point on the box that sees none, all six.
vec3 faces_seen(vec3 p, vec3 lo, vec3 hi) {
    float x = p.x < lo.x || hi.x < p.x ? 1.0 : 0.0;
    float y = p.y < lo.y || hi.y < p.y ? 1.0 : 0.0;
    float z = p.z < lo.z || hi.z < p.z ? 1.0 : 0.0;
    return x + y + z == 0.0 ? vec3(2.0) : vec3(x, y, z);
}

// The area of one face across each axis.
vec3 face_areas(vec3 e) {
    return vec3(e.y * e.z, e.z * e.x, e.x * e.y);
}

// Whether the upper face across an axis is chosen: the one that shows its front, or if both are sampled, the one that
// the second half of the choice selects.
bool upper_face(float p, float lo, float faces, float area, float choice) {
    return faces == 1.0 ? lo <= p : area <= choice;
}

// A point uniform over the faces that p sees; the face is chosen by u24 < 2^24.
LightSample box_light_sample(vec3 p, vec3 lo, vec3 hi, uint u24, vec2 u) {
    vec3 e = hi - lo;
    vec3 faces = faces_seen(p, lo, hi);
    vec3 face = face_areas(e);
    vec3 area = faces * face;
    float total = area.x + area.y + area.z;
    float choice = choice_below(u24, total);
    bool x = choice < area.x;
    bool y = !x && choice < area.x + area.y;
    bool z = !x && !y;
    float upper_x = upper_face(p.x, lo.x, faces.x, face.x, choice) ? 1.0 : 0.0;
    float upper_y = upper_face(p.y, lo.y, faces.y, face.y, choice - area.x) ? 1.0 : 0.0;
    float upper_z = upper_face(p.z, lo.z, faces.z, face.z, choice - (area.x + area.y)) ? 1.0 : 0.0;
    vec3 at = vec3(x ? upper_x : u.x, y ? upper_y : (x ? u.x : u.y), z ? upper_z : u.y);
    vec3 n = vec3(x ? 1.0 : 0.0, y ? 1.0 : 0.0, z ? 1.0 : 0.0);
    uint axis = x ? 0u : (y ? 1u : 2u);
    float upper = x ? upper_x : (y ? upper_y : upper_z);
    uint prim = 2u * axis + (upper == 1.0 ? 1u : 0u);
    return area_sample(lo + e * at - p, n, area_density(total), prim);
}

// Density of box_light_sample at a point that a path has hit at `distance` with the cosine |N_L.w|.
float box_light_pdf(vec3 p, vec3 lo, vec3 hi, float distance, float cosine) {
    vec3 area = faces_seen(p, lo, hi) * face_areas(hi - lo);
    return solid_angle_pdf(area_density(area.x + area.y + area.z), distance, cosine);
}
