#include "parser/statement/warp.hpp"

#include <algorithm>
#include <cmath>

namespace lute {
namespace {

int octaves(Reader& reader) { return std::clamp(reader.integer(), 1, 10); }

dvec3 orientation(Reader& reader) {
  const dvec3 direction = reader.vector();
  const double length = glm::length(direction);
  return length > 0 ? direction / length : direction;
}

RepeatWarp parse_repeat(Reader& reader) {
  RepeatWarp warp;
  const dvec3 along = reader.vector();
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0) continue;
    ++axes;
    warp.axis = axis;
    warp.width = static_cast<float>(along[axis]);
  }
  if (axes > 1) reader.error("Can only repeat along 1 axis.");
  if (axes == 0) reader.error("No axis specified in repeat.");
  while (true) {
    if (reader.accept(Word::kOffset)) {
      warp.offset = reader.vector();
    } else if (reader.accept(Word::kFlip)) {
      const dvec3 flip = reader.vector();
      for (int axis = 0; axis < 3; ++axis) warp.flip[axis] = flip[axis] != 0 ? -1 : 1;
    } else {
      break;
    }
  }
  return warp;
}

// Blocks must have room for the hole and its shift (specification chapter 50 §5.4).
void make_room(Reader& reader, BlackHoleWarp& warp) {
  if (!warp.repeat) return;
  bool raised = false;
  for (int axis = 0; axis < 3; ++axis) {
    double& width = (*warp.repeat)[axis];
    if (width > 0) {
      warp.center[axis] = std::max(warp.center[axis], warp.radius);
      const double least = warp.center[axis] + warp.radius + warp.turbulence[axis];
      if (width < least) {
        width = least;
        raised = true;
      }
    }
    if (width < kEpsilon) width = 0;
  }
  if (raised) reader.warning("Black hole repeat vector is too small: raised to hold the hole.");
}

BlackHoleWarp parse_black_hole(Reader& reader) {
  BlackHoleWarp warp;
  warp.center = reader.vector();
  reader.comma();
  warp.radius = reader.number();
  while (true) {
    if (reader.accept(Word::kStrength)) {
      warp.strength = reader.number();
    } else if (reader.accept(Word::kFalloff)) {
      warp.falloff = reader.number();
    } else if (reader.accept(Word::kInverse)) {
      warp.inverse = true;
    } else if (reader.accept(Word::kType)) {
      warp.type = reader.integer();
    } else if (reader.accept(Word::kRepeat)) {
      warp.repeat = reader.vector();
      make_room(reader, warp);
    } else if (reader.accept(Word::kTurbulence)) {
      warp.turbulence = reader.vector();
      make_room(reader, warp);
    } else {
      break;
    }
  }
  return warp;
}

template <class MappingWarp>
MappingWarp parse_mapping(Reader& reader) {
  MappingWarp warp;
  while (true) {
    if (reader.accept(Word::kOrientation)) {
      warp.orientation = orientation(reader);
      continue;
    }
    if (reader.accept(Word::kDistExp)) {
      warp.dist_exp = reader.number();
      continue;
    }
    if constexpr (requires { warp.major_radius; }) {
      if (reader.accept(Word::kMajorRadius)) {
        warp.major_radius = reader.number();
        continue;
      }
    }
    return warp;
  }
}

PlanarWarp parse_planar(Reader& reader) {
  PlanarWarp warp;
  if (reader.at_number()) {
    warp.orientation = orientation(reader);
    reader.comma();
    warp.offset = reader.number();
  }
  return warp;
}

TurbulenceWarp parse_turbulence_warp(Reader& reader) {
  TurbulenceWarp warp;
  warp.amount = reader.vector();
  while (!reader.at(Word::kTurbulence) && accept_turbulence_item(reader, warp)) {
  }
  return warp;
}

Warp parse_kind(Reader& reader) {
  if (reader.accept(Word::kRepeat)) return parse_repeat(reader);
  if (reader.accept(Word::kBlackHole)) return parse_black_hole(reader);
  if (reader.accept(Word::kTurbulence)) return parse_turbulence_warp(reader);
  if (reader.accept(Word::kCylindrical)) return parse_mapping<CylindricalWarp>(reader);
  if (reader.accept(Word::kSpherical)) return parse_mapping<SphericalWarp>(reader);
  if (reader.accept(Word::kToroidal)) return parse_mapping<ToroidalWarp>(reader);
  if (reader.accept(Word::kPlanar)) return parse_planar(reader);
  if (reader.accept(Word::kCubic)) return CubicWarp{};
  reader.error_expected("warp type");
}

}  // namespace

bool accept_turbulence_item(Reader& reader, Turbulence& turbulence) {
  if (reader.accept(Word::kTurbulence)) turbulence.amount = reader.vector();
  else if (reader.accept(Word::kOctaves)) turbulence.octaves = octaves(reader);
  else if (reader.accept(Word::kOmega)) turbulence.omega = static_cast<float>(reader.number());
  else if (reader.accept(Word::kLambda)) turbulence.lambda = static_cast<float>(reader.number());
  else return false;
  return true;
}

Turbulence& classic_turbulence(WarpChain& chain) {
  if (chain.empty() || !std::holds_alternative<ClassicTurbulence>(chain.back())) chain.emplace_back(ClassicTurbulence{});
  return std::get<ClassicTurbulence>(chain.back());
}

void parse_warp(Reader& reader, WarpChain& chain) {
  reader.open(Word::kWarp);
  Warp warp = parse_kind(reader);
  reader.close(Word::kWarp);
  chain.insert(chain.begin(), std::move(warp));
}

}  // namespace lute
