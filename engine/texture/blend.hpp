// Looking up a value in a blend map (specification chapter 50 §10.1). Entries are scanned in the order written.
#pragma once

#include <span>

namespace lute {

// The two neighbouring entries of a value: result = previous + t * (current - previous). Where one entry decides alone, both are
// that entry and t is 1.
template <class Entry>
struct Neighbours {
  const Entry* previous = nullptr;
  const Entry* current = nullptr;
  double t = 1;
  bool single() const { return previous == current; }
};

// `Entry` has a float `position`. `entries` is not empty.
template <class Entry>
Neighbours<Entry> find_neighbours(std::span<const Entry> entries, double value) {
  const Entry& last = entries.back();
  if (value >= static_cast<double>(last.position)) return {&last, &last, 1};
  const Entry* current = entries.data();
  // The scan ends before the last entry passes: value is below its position.
  while (value > static_cast<double>(current->position) && current != &last) ++current;
  if (current == entries.data() || value == static_cast<double>(current->position)) return {current, current, 1};
  const Entry* previous = current - 1;
  const double lo = static_cast<double>(previous->position), hi = static_cast<double>(current->position);
  return {previous, current, (value - lo) / (hi - lo)};
}

}  // namespace lute
