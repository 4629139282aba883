// The children of a combination that refused the last hits of a ray, asked first about the next: those of an intersection that do not
// contain a hit, those of a merge that do.
//
// In an intersection a child that the ray enters late refuses the entries into all others, and one that it leaves early all later
// hits. Whichever child refuses a hit, found in a mixed order, refuses on average half of those that are still refused; so after
// O(log N) searches among N children the few that matter stand here, and a ray costs O(N) inside tests in the mean instead of one for
// each hit and child. A hit is refused by any one child, so the order of asking changes no picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace lute {

class RecentRefusals {
 public:
  // Whether refuses(child) is true for one of the children kept; the latest to refuse are asked first.
  template <class Refuses>
  bool any(Refuses&& refuses) {
    for (std::size_t k = 0; k < count_; ++k) {
      if (!refuses(children_[k])) continue;
      if (k > 0) std::swap(children_[k], children_[k - 1]);
      return true;
    }
    return false;
  }

  // Puts a child in front; the last one gives way where there is no room.
  void add(std::uint32_t child) {
    if (count_ < children_.size()) ++count_;
    for (std::size_t k = count_ - 1; k > 0; --k) children_[k] = children_[k - 1];
    children_[0] = child;
  }

 private:
  std::array<std::uint32_t, 8> children_;
  std::size_t count_ = 0;
};

}  // namespace lute
