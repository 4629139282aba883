// Memory of one thread that shading uses again and again: stacks that grow to the need of the deepest ray and stay.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/accel/scene_tree.hpp"
#include "engine/csg/csg_solid.hpp"
#include "engine/light/light.hpp"
#include "engine/scene/finish.hpp"

namespace lute {

// What is known of one light at the point being shaded. Layers and blended textures share it.
struct LightAtPoint {
  bool reached = false;   // path and color are known
  bool shadowed = false;  // so is what the shadows leave
  LightPath path;
  Rgb color;              // with the attenuations of angle and distance
  Rgb after_shadows;
};

// A layer whose reflection is added once all layers are lit.
struct ReflectingLayer {
  Rgb amount;
  float weight;
  dvec3 normal;
  const Finish* finish;
};

// A stack whose items stay as they were left when it shrinks, so that using a place again costs nothing.
template <class T>
class ScratchStack {
 public:
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return items_[i]; }
  void resize(std::size_t size) {
    if (size > room_) grow(size);
    size_ = size;
  }
  void push(const T& item) {
    resize(size_ + 1);
    items_[size_ - 1] = item;
  }

 private:
  void grow(std::size_t size) {
    items_.resize(size);
    room_ = size;
  }

  std::vector<T> items_;
  std::size_t size_ = 0, room_ = 0;
};

// A piece of a stack, given back when the scope ends; its items begin with anything. Address them by index only: the stack may move.
template <class T>
class ScratchBlock {
 public:
  ScratchBlock(ScratchStack<T>& stack, std::size_t count) : stack_(stack), first_(stack.size()) { stack.resize(first_ + count); }
  explicit ScratchBlock(ScratchStack<T>& stack) : ScratchBlock(stack, 0) {}
  ~ScratchBlock() { stack_.resize(first_); }
  ScratchBlock(const ScratchBlock&) = delete;
  ScratchBlock& operator=(const ScratchBlock&) = delete;

  T& operator[](std::size_t i) { return stack_[first_ + i]; }
  std::size_t size() const { return stack_.size() - first_; }

 private:
  ScratchStack<T>& stack_;
  std::size_t first_;
};

struct TraceScratch {
  ScratchStack<LightAtPoint> lights;
  ScratchStack<ReflectingLayer> reflections;
  ScratchStack<Rgb> area_samples;
  std::vector<TextureWeight> weights;
  CsgSolid::CutawayShares shares;
  // Of each light two: for what the camera sees directly, and for what is seen in mirrors and through glass.
  std::vector<std::array<LastBlocker, 2>> last_blockers;
};

}  // namespace lute
