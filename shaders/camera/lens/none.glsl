// A pinhole: every point sees the same eye. Fills the slot <lens>.
// uses: camera/eye

EyeSample eye_drawn(uint pixel_index, uint sample_index, uint block, vec3 p) {
    return eye_sample(camera, p);
}
