// Where the tokens of a file lie: room for all that its text could hold is taken at once, so that none of them ever moves, but
// only pages that were written to take memory; and those that are not needed any more can be given back.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

#include "parser/lexer/token.hpp"

namespace lute {

// An allocator. Raises std::bad_alloc like any other.
template <class T>
struct ReservedPages {
  using value_type = T;
  ReservedPages() = default;
  template <class U>
  explicit ReservedPages(const ReservedPages<U>&) {}

  T* allocate(std::size_t count) {
    if (!is_large(count)) return static_cast<T*>(::operator new(count * sizeof(T)));
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
    void* const pages =
        mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (pages == MAP_FAILED) throw std::bad_alloc();
    return static_cast<T*>(pages);
  }
  void deallocate(T* pages, std::size_t count) {
    if (is_large(count)) {
      munmap(pages, count * sizeof(T));
    } else {
      ::operator delete(pages);
    }
  }
  // The memory of these is given back, as far as they fill pages; what is read there later is 0. Nothing happens where little is
  // held in all.
  static void give_back(T* from, T* to, std::size_t capacity) {
    if (!is_large(capacity) || from >= to) return;
    const auto page = static_cast<std::uintptr_t>(std::max(sysconf(_SC_PAGESIZE), 4096L));
    const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(from) + page - 1) / page * page;
    const std::uintptr_t end = reinterpret_cast<std::uintptr_t>(to) / page * page;
    if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
  }

  friend bool operator==(const ReservedPages&, const ReservedPages&) { return true; }

 private:
  static constexpr std::size_t kLarge = 1u << 16;
  static bool is_large(std::size_t count) { return count >= kLarge; }
};

using Tokens = std::vector<Token, ReservedPages<Token>>;

}  // namespace lute
