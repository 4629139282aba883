#include "parser/diagnostic/statement_form.hpp"

#include <algorithm>
#include <iterator>

namespace lute {

namespace {

struct Form {
  std::string_view keyword, form;
};

// Source: specification chapters 11 and 20.
constexpr Form kForms[] = {
    {"box", "box { <corner>, <opposite corner> ... }"},
    {"cone", "cone { <base>, radius, <cap>, radius ... }"},
    {"cylinder", "cylinder { <base>, <cap>, radius ... }"},
    {"disc", "disc { <center>, <normal>, radius ... }"},
    {"light_source", "light_source { <place>, color ... }"},
    {"plane", "plane { <normal>, distance ... }"},
    {"quadric", "quadric { <a, b, c>, <d, e, f>, <g, h, i>, j ... }"},
    {"smooth_triangle", "smooth_triangle { <corner>, <normal>, <corner>, <normal>, <corner>, <normal> ... }"},
    {"sphere", "sphere { <center>, radius ... }"},
    {"superellipsoid", "superellipsoid { <e, n> ... }"},
    {"text", "text { ttf \"font.ttf\" \"text\" thickness, <offset> ... }"},
    {"torus", "torus { major radius, minor radius ... }"},
    {"triangle", "triangle { <corner>, <corner>, <corner> ... }"},
};

}  // namespace

std::string_view statement_form(std::string_view keyword) {
  const auto found = std::ranges::find(kForms, keyword, &Form::keyword);
  return found == std::end(kForms) ? std::string_view() : found->form;
}

}  // namespace lute
