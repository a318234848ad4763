// At most MAX_DEPTH bounces.

bool depth_reached(uint bounce) {
    return bounce >= MAX_DEPTH;
}
