// Spheres as lights.
// Twin of src/reference/light/sphere.rs.

// uses: math/vec, math/frame, math/elementary/sincos, light/sample

// 4pi and 1/2pi
const float FOUR_PI = 12.566370614359172;
const float INV_2PI = 0.15915494309189535;

// 1 - cos theta_max of the cone that a sphere of radius r subtends at a distance d > r from its centre.
//
// sin²/(1 + cos), with sin = r/d and cos² = (1 - sin)(1 + sin): no digit is lost, even for tiny spheres
// or next to the surface.
float cone_height(float radius, float distance) {
    float sine = radius / distance;
    float cosine = sqrt((distance - radius) / distance * (1.0 + sine));
    return sine * sine / (1.0 + cosine);
}

// 1/(2pi (1 - cos theta_max)); 0 for a sphere so small that f32 cannot represent it.
float cone_pdf(float height) {
    bool lost = height < 1e-37;
    float pdf = INV_2PI / (lost ? 1.0 : height);
    return lost ? 0.0 : pdf;
}

// 1/(4pi r²)
float sphere_density(float radius) {
    return area_density(FOUR_PI * (radius * radius));
}

// A direction uniform in a cone about z, 1 - cos theta = h = u1 height, sin² theta = h (2 - h).
vec3 cone_direction(float height, vec2 u) {
    float h = u.x * height;
    float sine = sqrt(h * (2.0 - h));
    vec2 sincos = sincos_2pi(u.y);
    return vec3(sine * sincos.y, sine * sincos.x, 1.0 - h);
}

// Uniform in the cone about `axis`, of length d: 1 - cos theta = h = u1 (1 - cos theta_max), sin² theta = h (2 - h).
//
// The distance to the near side is (d² - r²)/(d cos theta + sqrt(r² - d² sin² theta)), where the root is
// d sqrt((h_max - h)(2 - h_max - h)), since r = d sin theta_max.
LightSample cone_sample(vec3 axis, float d, float radius, vec2 u) {
    float height = cone_height(radius, d);
    float h = u.x * height;
    float root = sqrt(height * (1.0 - u.x) * (2.0 - height - h));
    vec3 wi = to_world(frame_about(axis / d), cone_direction(height, u));
    float distance = (d - radius) * ((d + radius) / d) / (1.0 - h + root);
    return LightSample(wi, distance, cone_pdf(height), root * d / radius, 0u);
}

// A direction uniform in the cone that the sphere subtends; from inside, or from a point on it, where no cone exists, a
// point uniform on the sphere.
LightSample sphere_light_sample(vec3 p, vec3 centre, float radius, vec2 u) {
    vec3 axis = centre - p;
    float d = length3(axis);
    LightSample result;
    if (d > radius) {
        result = cone_sample(axis, d, radius, u);
    } else {
        vec3 n = unit_sphere(u);
        result = area_sample(axis + n * radius, n, sphere_density(radius), 0u);
    }
    return result;
}

// Density of sphere_light_sample at a point that a path has hit at `distance` with the cosine |N_L.w|; both
// matter only from inside.
float sphere_light_pdf(vec3 p, vec3 centre, float radius, float distance, float cosine) {
    float d = length3(centre - p);
    float outside = cone_pdf(cone_height(radius, d));
    float inside = solid_angle_pdf(sphere_density(radius), distance, cosine);
    return d > radius ? outside : inside;
}
