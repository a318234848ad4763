// A path carries L/n^2, as in the hand-out (model.md, "Radiance scaling").
// Twin of src/reference/bsdf/scaling/flux.rs. Fills the slot <scaling>.

// uses:

// 1
float transmission_scale(float eta) {
    return 1.0;
}
