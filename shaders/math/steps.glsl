// How many times loop bodies of this invocation have run. Mesa 22 ends all loops in silence after 65,535 iterations
// of a subgroup and dispatch, so the kernel counts and hands an unfinished path over before that.
// Every loop body begins with `loop_steps += 1u;`.

// uses:

uint loop_steps = 0u;

// Set where a loop was ended before its own end condition held: what came of it must not be used.
bool loop_failed = false;
