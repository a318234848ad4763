// Nothing emits: no light path begins. Fills the slot <light_start>.
// uses: constants/none, integrator/light/start/point

LightStart light_start(uint pixel_index, uint sample_index) {
    return LightStart(no_emission(), vec3(0.0), 0.0, NONE, 0u, NONE, false);
}
