// Only roulette limits the length of paths.

bool depth_reached(uint bounce) {
    return false;
}
