#include "core/freed_memory.hpp"

#include <cstdlib>  // tells which C library this is

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace shellback {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMapped =
      32 << 20;  // blocks above are mapped on their own: glibc allows no more [byte]
  constexpr int kTrimmed = 512 << 20;  // free memory at the end of the heap that is kept [byte]
  mallopt(M_MMAP_THRESHOLD, kMapped);
  mallopt(M_TRIM_THRESHOLD, kTrimmed);
#endif
}

}  // namespace shellback
