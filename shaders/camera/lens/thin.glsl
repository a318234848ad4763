// A point of the lens, drawn for each point that is connected to the eye. Fills the slot <lens>.
// Twin of src/reference/camera/lens.rs.
// uses: camera/lens, sampler/unit_float, <sampler>, <blocks>

EyeSample eye_drawn(uint pixel_index, uint sample_index, uint block, vec3 p) {
    uvec4 u = sampler_block(pixel_index, sample_index, path_block(block), camera.seed);
    return lens_sample(camera, lens[0], disc_point(vec2(unit_float(u.z), unit_float(u.w))), p);
}
