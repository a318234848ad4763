// Eye paths carry what the settings say, light paths the adjoint of it. Fills the slot <scaling>.

// uses: path/origin

// eta^2 or 1
float transmission_scale(float eta) {
    return from_light != RADIANCE_SCALING ? eta * eta : 1.0;
}
