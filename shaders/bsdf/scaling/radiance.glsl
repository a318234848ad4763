// A path carries radiance; refraction conserves L/n^2 (model.md, "Radiance scaling").
// Twin of src/reference/bsdf/scaling/radiance.rs. Fills the slot <scaling>.

// uses:

// eta^2
float transmission_scale(float eta) {
    return eta * eta;
}
