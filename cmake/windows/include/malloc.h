// Adds to Windows' <malloc.h> the size of a block under glibc's name.
#pragma once

#include_next <malloc.h>

inline size_t malloc_usable_size(void* block) {
  return _msize(block);
}
