#include "tests/allocation/heap_calls.hpp"

#include <malloc.h>

#include <cerrno>
#include <cstddef>

namespace {

thread_local constinit wheelwright::test::HeapCalls* counter = nullptr;

void count() {
  if (counter != nullptr) counter->fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

// The names and signatures are the C library's.
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) {
  count();
  return __libc_malloc(size);
}

void* calloc(std::size_t members, std::size_t size) {
  count();
  return __libc_calloc(members, size);
}

void* realloc(void* block, std::size_t size) {
  count();
  return __libc_realloc(block, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  count();
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count();
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  count();
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}

void free(void* block) {
  if (block != nullptr) count();
  __libc_free(block);
}
}

namespace wheelwright::test {

void count_heap_calls_in(HeapCalls* calls) {
  counter = calls;
}

}  // namespace wheelwright::test
