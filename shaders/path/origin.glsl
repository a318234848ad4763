// The end at which a path began, in a kernel that evaluates BSDFs for paths from both: the slots <correction> and
// <scaling> depend on it.

// uses:

bool from_light = false;
