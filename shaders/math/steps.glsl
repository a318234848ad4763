// The number of loop bodies that this invocation has run. Mesa 22 ends all loops silently after 65,535 iterations
// of a subgroup and dispatch, so the kernel counts and passes an unfinished path on before that.
// Every loop body begins with `loop_steps += 1u;`.

// uses:

uint loop_steps = 0u;

// Set where a loop ended before its own end condition was met: its results must not be used.
bool loop_failed = false;
