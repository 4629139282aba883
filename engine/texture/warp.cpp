#include "engine/texture/warp.hpp"

namespace lute {

void prepend_transform(WarpChain& chain, const Transform& transform) {
  if (!chain.empty())
    if (auto* first = std::get_if<Transform>(&chain.front())) {
      *first = first->then(transform);
      return;
    }
  chain.insert(chain.begin(), Warp(transform));
}

}  // namespace lute
