// Beer's law.
// uses: math/elementary/exp

// A(t) = Kt^t = exp(−σt), and 1 where σ or t is 0 (model.md, "Absorption").
float beer(float sigma, float t) {
    return sigma == 0.0 || t == 0.0 ? 1.0 : exp(-(sigma * t));
}

vec3 beer3(vec3 sigma, float t) {
    return vec3(beer(sigma.x, t), beer(sigma.y, t), beer(sigma.z, t));
}
