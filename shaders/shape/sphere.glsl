// Spheres.
// Twin of src/reference/shape/sphere.rs.

// uses: constants/ray, math/vec, shape/ray

// Distance to the sphere's surface along the unit vector d, or -1.
//
// `start` is the ray's relation to this sphere. If it leaves to the outside: never. To the inside: |oc| = r makes the
// roots 0 and -2 oc.d, and the second is the exit, at least 0. From elsewhere: the least t > 0. Haines, Günther,
// Akenine-Möller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems (2019), chapter 7: the
// discriminant from the ray's distance to the centre, r² - |oc - (oc.d) d|², and the smaller root as c/q. If both q and
// c are only rounding errors, for a ray that starts on the sphere and along it, c/q is arbitrary; so it is clamped to
// within sqrt(disc) of its true place.
float sphere_hit(vec3 o, vec3 d, vec3 centre, float radius, uint start) {
    vec3 oc = o - centre;
    float b = -dot3(oc, d);
    vec3 l = oc + d * b;
    float disc = radius * radius - dot3(l, l);
    float root = sqrt(max2(disc, 0.0));
    float q = b < 0.0 ? b - root : b + root;
    float distance = length3(oc);
    // The product of the roots is c = |oc|² - r², without the cancellation.
    float c = (distance - radius) * (distance + radius);
    float quotient = q == 0.0 ? 0.0 : c / q;
    float other = min2(max2(quotient, b - (root + root)), b + (root + root));
    float near = b < 0.0 ? q : other;
    float far = b < 0.0 ? other : q;
    float ahead = near > 0.0 ? near : far;
    float elsewhere = disc >= 0.0 && ahead > 0.0 ? ahead : -1.0;
    float inside = max2(b + b, 0.0);
    return start == START_ELSEWHERE ? elsewhere : (start == START_INSIDE ? inside : -1.0);
}

// The point that was hit, moved along the radius onto the sphere.
Surface sphere_surface(Ray ray, Hit hit, Sphere sphere) {
    vec3 v = ray.o - sphere.centre + ray.d * hit.t;
    float length = length3(v);
    // If the radius is below the resolution of the coordinates, take the side that faces the ray, or
    // from within the other one.
    bool lost = length == 0.0;
    bool leaves = start_on(ray, sphere.shape) == START_INSIDE;
    vec3 n = lost ? (leaves ? ray.d : -ray.d) : v / (lost ? 1.0 : length);
    return Surface(sphere.centre + n * sphere.radius, n, n);
}
