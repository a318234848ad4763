// Vectors with every sum in a written-out order. GLSL's own dot, length, normalize, min and max leave the order,
// the rounding or the result for a NaN to the driver.
// Twin of src/reference/math/vec.rs.

// uses:

float min2(float a, float b) {
    return b < a ? b : a;
}

float max2(float a, float b) {
    return a < b ? b : a;
}

// a.b = (a.x b.x + a.y b.y) + a.z b.z
float dot3(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// a x b
vec3 cross3(vec3 a, vec3 b) {
    return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// |v| = sqrt(v.v)
float length3(vec3 v) {
    return sqrt(dot3(v, v));
}

// v (1/|v|); for |v| between 1e-18 and 1e19, outside of which the squares leave the range of a float.
vec3 normalize3(vec3 v) {
    return v * (1.0 / length3(v));
}

// The largest of the three components.
float max_component(vec3 v) {
    return max2(max2(v.x, v.y), v.z);
}

// (x + y + z)/3, the mean over RGB, of grey exactly: x + ((y - x) + (z - x))/3.
float mean3(vec3 v) {
    return v.x + ((v.y - v.x) + (v.z - v.x)) * 0.33333334;
}
