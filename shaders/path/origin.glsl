// The end that a path began at, in a kernel that evaluates BSDFs for paths from both: what the slots <correction> and
// <scaling> depend on.

// uses:

bool from_light = false;
