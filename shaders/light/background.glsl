// The constant background as a light.
// Twin of src/reference/light/background.rs.

// uses: constants/none, light/outside, light/sample

// 1/4pi
float background_light_pdf() {
    return 0.07957747154594767;
}

// A direction uniform over the sphere.
LightSample background_light_sample(vec2 u) {
    return LightSample(unit_sphere(u), -1.0, background_light_pdf(), 1.0, NONE);
}

// The same along every direction.
Outside background_outside(vec3 radiance) {
    return Outside(radiance, background_light_pdf());
}
