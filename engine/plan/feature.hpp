// Whether a scene needs a feature. A build may leave features out for good: then the answer is a constant and the compiler drops what
// hangs on it. That is how docs/cost.md proves that a scene pays nothing for what it does not use:
//   cmake -DLUTE_LEAVE_OUT="fog;reflection"
#pragma once

namespace lute {

template <bool kCompiled>
class Feature {
 public:
  Feature& operator=(bool needed) {
    needed_ = needed;
    return *this;
  }
  constexpr operator bool() const { return kCompiled && needed_; }

 private:
  bool needed_ = false;
};

#ifdef LUTE_WITHOUT_FOG
constexpr bool kFogCompiled = false;
#else
constexpr bool kFogCompiled = true;
#endif
#ifdef LUTE_WITHOUT_HIGHLIGHTS
constexpr bool kHighlightsCompiled = false;
#else
constexpr bool kHighlightsCompiled = true;
#endif
#ifdef LUTE_WITHOUT_NORMALS
constexpr bool kNormalsCompiled = false;
#else
constexpr bool kNormalsCompiled = true;
#endif
#ifdef LUTE_WITHOUT_REFLECTION
constexpr bool kReflectionCompiled = false;
#else
constexpr bool kReflectionCompiled = true;
#endif
#ifdef LUTE_WITHOUT_TRANSMISSION
constexpr bool kTransmissionCompiled = false;
#else
constexpr bool kTransmissionCompiled = true;
#endif

}  // namespace lute
