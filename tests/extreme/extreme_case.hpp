// Scenes that break renderers, each with an oracle that does not come from a renderer.
//
// The one table, cases(), drives the tests (tests/extreme/extreme_test.cpp) and the rows of docs/accuracy.md
// (tests/accuracy/main.cpp). The error of a case is the share of pixels that differ from the oracle by more than 2/255
// in a channel.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tests/extreme/real.hpp"

namespace lute::extreme {

using Rgb = std::array<double, 3>;

// A picture in closed form: the light that belongs to an image position, (0, 0) the middle, ±1/2 the edges, y upward.
// Without a value where the position is so near to an edge that the rounding of the scene's own numbers decides.
using ClosedForm = std::function<std::optional<Rgb>(Real a, Real b)>;

// One more render of the scene, which must give the picture of the first.
struct Variant {
  std::string name;
  std::vector<std::string> declares;  // "Exponent=-9"
};
using Symmetry = std::vector<Variant>;

struct ExtremeCase {
  std::string name;                   // of the test and the row
  std::string scene;                  // file in scenes/extreme
  std::vector<std::string> declares;  // for the first picture
  std::variant<ClosedForm, Symmetry> oracle;
  double allowed = 0;  // the largest error that passes
  std::string rule;    // where the allowed error comes from
};

inline constexpr int kWidth = 80, kHeight = 60;

const std::vector<ExtremeCase>& cases();

// An oracle that leaves more undecided is none.
inline constexpr double kMostUndecided = 0.02;

struct Measured {
  double error = 1;      // the worst of all variants
  double undecided = 0;  // share of the pixels about which the oracle says nothing
  std::string worst;    // the variant
  std::string failure;  // not empty: no picture, and why
};

// Renders the case with a program that takes POV-Ray's switches.
Measured measure(const ExtremeCase& extreme, const std::string& program);

}  // namespace lute::extreme
