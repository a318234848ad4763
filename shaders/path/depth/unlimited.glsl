// Paths are as long as roulette lets them be.

bool depth_reached(uint bounce) {
    return false;
}
