// Orthonormal frames about a normal.
// Twin of src/reference/math/frame.rs.

// uses: math/vec

// A right-handed frame (t, b, n), each of unit length.
struct Frame {
    vec3 t;
    vec3 b;
    vec3 n;
};

// A frame about the unit vector n, without a branch and without a singular direction.
// Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017, listing 3. Exact for axis-aligned n.
Frame frame_about(vec3 n) {
    float s = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    vec3 t = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    return Frame(t, vec3(b, s + n.y * n.y * a, -n.y), n);
}

// World to local: (v.t, v.b, v.n).
vec3 to_local(Frame f, vec3 v) {
    return vec3(dot3(v, f.t), dot3(v, f.b), dot3(v, f.n));
}

// Local to world: t v.x + b v.y + n v.z.
vec3 to_world(Frame f, vec3 v) {
    return f.t * v.x + f.b * v.y + f.n * v.z;
}
