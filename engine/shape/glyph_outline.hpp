// The outlines of a line of text, read from a TrueType font (FreeType). Source: specification chapter 21 §10.2-10.4.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/math/vec.hpp"

namespace lute {

// A piece of an outline: a parabola from p0 to p2 with control point p1, a line if p1 is their middle. It rises or falls all the way:
// curves are cut at their highest and lowest points.
struct OutlinePiece {
  dvec2 p0, p1, p2;

  dvec2 at(double w) const { return (1 - w) * (1 - w) * p0 + 2 * w * (1 - w) * p1 + w * w * p2; }
  dvec2 tangent(double w) const { return 2 * (1 - w) * (p1 - p0) + 2 * w * (p2 - p1); }
};

struct GlyphOutline {
  std::vector<OutlinePiece> pieces;
  dvec2 lo{0}, hi{0};  // their box; meaningless without pieces
  dvec2 stated_lo{0}, stated_hi{0};  // the box that the font states, about the outline too; a point where there is none
};

// Throws std::runtime_error ("Cannot read TrueType font file.") if `font` is none.
void check_font(std::string_view font);

// Glyphs side by side, blanks among them, in units of the font's em, the baseline at y = 0. Throws as check_font does. `offset` is added after each
// character; `unicode_first`: which character table is preferred.
std::vector<GlyphOutline> lay_out_text(std::string_view font, std::u16string_view text, const dvec2& offset, bool unicode_first);

}  // namespace lute
