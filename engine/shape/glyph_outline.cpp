#include "engine/shape/glyph_outline.hpp"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <stdexcept>

#include <ft2build.h>

#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

#include <glm/common.hpp>

namespace lute {

namespace {

struct LibraryCloser {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct FaceCloser {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using Library = std::unique_ptr<std::remove_pointer_t<FT_Library>, LibraryCloser>;
using Face = std::unique_ptr<std::remove_pointer_t<FT_Face>, FaceCloser>;

Library open_library() {
  FT_Library raw = nullptr;
  if (FT_Init_FreeType(&raw) != 0) throw std::runtime_error("Cannot read TrueType font file.");
  return Library(raw);
}

Face open_face(FT_Library library, std::string_view font) {
  FT_Face face = nullptr;
  const auto* bytes = reinterpret_cast<const FT_Byte*>(font.data());
  if (FT_New_Memory_Face(library, bytes, static_cast<FT_Long>(font.size()), 0, &face) != 0)
    throw std::runtime_error("Cannot read TrueType font file.");
  Face owned(face);
  if (!FT_IS_SFNT(face) || !FT_IS_SCALABLE(face)) throw std::runtime_error("Cannot read TrueType font file.");
  return owned;
}

// The first character table of a usable format, by platform.
FT_CharMap choose_charmap(FT_Face face, bool unicode_first) {
  constexpr int kMacintosh = 1, kMicrosoft = 3, kUnicode = 0;
  const std::initializer_list<int> ascii{kMacintosh, kMicrosoft, kUnicode};
  const std::initializer_list<int> unicode{kUnicode, kMicrosoft, kMacintosh};
  for (const int platform : unicode_first ? unicode : ascii) {
    for (int i = 0; i < face->num_charmaps; ++i) {
      FT_CharMap map = face->charmaps[i];
      const FT_Long format = FT_Get_CMap_Format(map);
      if (map->platform_id == platform && (format == 0 || format == 4 || format == 6)) return map;
    }
  }
  return nullptr;
}

FT_UInt glyph_index(FT_Face face, char16_t code) {
  const FT_UInt index = FT_Get_Char_Index(face, code);
  // Symbol fonts keep their characters in Unicode's private area.
  if (index == 0 && code < 256 && face->charmap != nullptr && FT_Get_CMap_Format(face->charmap) == 4)
    return FT_Get_Char_Index(face, 0xF000u + code);
  return index;
}

// Collects an outline, in units of the em.
struct Tracer {
  GlyphOutline& glyph;
  double scale;
  dvec2 shift;
  dvec2 start{0}, pen{0};

  dvec2 point(const FT_Vector* v) const { return scale * dvec2(static_cast<double>(v->x), static_cast<double>(v->y)) + shift; }

  void add(const OutlinePiece& piece) {
    if (piece.p0 == piece.p2 && piece.p0 == piece.p1) return;
    for (const dvec2& p : {piece.p0, piece.p2}) {
      glyph.lo = glyph.pieces.empty() ? p : glm::min(glyph.lo, p);
      glyph.hi = glyph.pieces.empty() ? p : glm::max(glyph.hi, p);
      if (glyph.pieces.empty()) glyph.pieces.reserve(32);
    }
    glyph.lo = glm::min(glyph.lo, piece.p1);
    glyph.hi = glm::max(glyph.hi, piece.p1);
    glyph.pieces.push_back(piece);
  }

  void line_to(const dvec2& to) {
    if (to != pen) add({pen, 0.5 * (pen + to), to});
    pen = to;
  }

  void curve_to(const dvec2& control, const dvec2& to) {
    // Where the slope of y is zero, if that is within the piece.
    const double a = control.y - pen.y;
    const double b = to.y - control.y;
    const double turn = a / (a - b);
    if (a * b < 0 && turn > 0 && turn < 1) {
      const dvec2 left = glm::mix(pen, control, turn);
      const dvec2 right = glm::mix(control, to, turn);
      dvec2 middle = glm::mix(left, right, turn);
      add({pen, {left.x, middle.y}, middle});
      add({middle, {right.x, middle.y}, to});
    } else {
      add({pen, control, to});
    }
    pen = to;
  }
};

// FreeType takes the middle of two control points in whole units: with finer ones nothing is rounded away.
constexpr int kOutlineShift = 6;

void trace_outline(FT_Outline& outline, Tracer& tracer) {
  static const FT_Outline_Funcs kCallbacks{
      [](const FT_Vector* to, void* user) {
        auto& t = *static_cast<Tracer*>(user);
        t.line_to(t.start);
        t.start = t.pen = t.point(to);
        return 0;
      },
      [](const FT_Vector* to, void* user) {
        auto& t = *static_cast<Tracer*>(user);
        t.line_to(t.point(to));
        return 0;
      },
      [](const FT_Vector* control, const FT_Vector* to, void* user) {
        auto& t = *static_cast<Tracer*>(user);
        t.curve_to(t.point(control), t.point(to));
        return 0;
      },
      [](const FT_Vector* c1, const FT_Vector* c2, const FT_Vector* to, void* user) {
        // Only fonts that are not TrueType have these; the nearest parabola serves.
        auto& t = *static_cast<Tracer*>(user);
        const dvec2 end = t.point(to);
        t.curve_to(0.75 * (t.point(c1) + t.point(c2)) - 0.25 * (t.pen + end), end);
        return 0;
      },
      kOutlineShift, 0};
  FT_Outline_Decompose(&outline, &kCallbacks, &tracer);
  tracer.line_to(tracer.start);
}

}  // namespace

void check_font(std::string_view font) { open_face(open_library().get(), font); }

std::vector<GlyphOutline> lay_out_text(std::string_view font, std::u16string_view text, const dvec2& offset, bool unicode_first) {
  const Library library = open_library();
  const Face face = open_face(library.get(), font);
  if (FT_CharMap map = choose_charmap(face.get(), unicode_first)) FT_Set_Charmap(face.get(), map);
  const double scale = 1.0 / face->units_per_EM;

  std::vector<GlyphOutline> glyphs;
  dvec2 pen(0);
  FT_UInt before = 0;
  bool first = true;
  for (const char16_t code : text) {
    const FT_UInt index = glyph_index(face.get(), code);
    if (FT_Load_Glyph(face.get(), index, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) continue;
    FT_GlyphSlot slot = face->glyph;
    const double advance = scale * static_cast<double>(slot->metrics.horiAdvance);
    const double bearing = scale * static_cast<double>(slot->metrics.horiBearingX);  // FreeType puts the outline there
    FT_Vector kern{0, 0};
    if (!first && FT_HAS_KERNING(face.get())) FT_Get_Kerning(face.get(), before, index, FT_KERNING_UNSCALED, &kern);
    const dvec2 kerned = scale * dvec2(static_cast<double>(kern.x), static_cast<double>(kern.y));
    GlyphOutline glyph;
    Tracer tracer{glyph, scale / (1 << kOutlineShift), first ? dvec2(-bearing, 0) : pen + kerned};
    trace_outline(slot->outline, tracer);
    if (!glyph.pieces.empty()) glyphs.push_back(std::move(glyph));
    pen.x += first ? advance - bearing : advance + kerned.x;
    pen += offset;
    before = index;
    first = false;
  }
  return glyphs;
}

}  // namespace lute
