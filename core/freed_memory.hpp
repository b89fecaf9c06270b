#pragma once
/// Freed memory is kept for the next field of the same size.

namespace shellback {

/// Tells the C library's allocator to keep what is freed instead of giving it back to the system at
/// once: a solver makes and drops fields of the same sizes all the time, and every page that comes
/// back from the system is cleared first. Peak memory stays as it is. For the start of a program;
/// no effect with other C libraries than glibc.
void keep_freed_memory();

}  // namespace shellback
