// Eye paths scale as the settings say, light paths as their adjoint. Fills the slot <scaling>.

// uses: path/origin

// eta^2 or 1
float transmission_scale(float eta) {
    return from_light != RADIANCE_SCALING ? eta * eta : 1.0;
}
