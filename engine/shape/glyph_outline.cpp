#include "engine/shape/glyph_outline.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>

#include <ft2build.h>

#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H

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

// Two bytes of a font's table; `complete` becomes false where the table ends before.
std::int16_t word_at(FT_Face face, FT_ULong table, FT_Long offset, bool& complete) {
  FT_Byte bytes[2] = {0, 0};
  FT_ULong length = 2;
  if (FT_Load_Sfnt_Table(face, table, offset, bytes, &length) != 0) complete = false;
  return static_cast<std::int16_t>(bytes[0] << 8 | bytes[1]);
}

// What a font says of a glyph, in its own units. The box may be wrong: FreeType's is that of the outline.
struct StatedGlyph {
  FT_Long bearing = 0;  // of the box's left side from the pen
  FT_Long x_min = 0, y_min = 0, x_max = 0, y_max = 0;
};

// None where there is no such glyph of its own: blanks, glyphs put together from others, fonts that are not TrueType.
std::optional<StatedGlyph> stated_glyph(FT_Face face, FT_UInt index) {
  const auto* head = static_cast<const TT_Header*>(FT_Get_Sfnt_Table(face, FT_SFNT_HEAD));
  const auto* metrics = static_cast<const TT_HoriHeader*>(FT_Get_Sfnt_Table(face, FT_SFNT_HHEA));
  FT_ULong glyf_length = 0;
  if (head == nullptr || metrics == nullptr || FT_Load_Sfnt_Table(face, TTAG_glyf, 0, nullptr, &glyf_length) != 0) return std::nullopt;
  bool complete = true;
  const auto word = [&](FT_ULong table, FT_Long offset) { return FT_Long{word_at(face, table, offset, complete)}; };
  const auto place = [&](FT_Long i) {
    if (head->Index_To_Loc_Format == 0) return 2 * (word(TTAG_loca, 2 * i) & 0xffff);
    return (word(TTAG_loca, 4 * i) & 0xffff) << 16 | (word(TTAG_loca, 4 * i + 2) & 0xffff);
  };
  const FT_Long start = place(index);
  if (place(FT_Long{index} + 1) <= start || word(TTAG_glyf, start) < 0) return std::nullopt;
  const FT_Long pairs = metrics->number_Of_HMetrics, i = index;
  const StatedGlyph result{word(TTAG_hmtx, i < pairs ? 4 * i + 2 : 4 * pairs + 2 * (i - pairs)), word(TTAG_glyf, start + 2),
                           word(TTAG_glyf, start + 4), word(TTAG_glyf, start + 6), word(TTAG_glyf, start + 8)};
  return complete ? std::optional(result) : std::nullopt;
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
    const FT_Glyph_Metrics& drawn = slot->metrics;
    StatedGlyph stated{drawn.horiBearingX, drawn.horiBearingX, drawn.horiBearingY - drawn.height, drawn.horiBearingX + drawn.width,
                       drawn.horiBearingY};
    if (const auto own = stated_glyph(face.get(), index)) stated = *own;
    const double bearing = scale * static_cast<double>(stated.bearing);  // FreeType puts the left side of the stated box there
    // The glyph begins where its outline does, should that leave the box.
    const double outside = scale * static_cast<double>(std::max<FT_Long>(0, stated.bearing - drawn.horiBearingX));
    FT_Vector kern{0, 0};
    if (!first && FT_HAS_KERNING(face.get())) FT_Get_Kerning(face.get(), before, index, FT_KERNING_UNSCALED, &kern);
    const dvec2 kerned = scale * dvec2(static_cast<double>(kern.x), static_cast<double>(kern.y));
    GlyphOutline glyph;
    const dvec2 place = (first ? dvec2(-bearing, 0) : pen + kerned) + dvec2(outside, 0);
    Tracer tracer{glyph, scale / (1 << kOutlineShift), place};
    trace_outline(slot->outline, tracer);
    const dvec2 corner = place + dvec2(bearing, 0);
    const dvec2 lo(0, static_cast<double>(stated.y_min));
    const dvec2 hi(static_cast<double>(stated.x_max - stated.x_min), static_cast<double>(stated.y_max));
    glyph.stated_lo = corner + scale * lo;
    glyph.stated_hi = corner + scale * hi;
    if (!glyph.pieces.empty()) {
      glyph.stated_lo = glm::min(glyph.stated_lo, glyph.lo);
      glyph.stated_hi = glm::max(glyph.stated_hi, glyph.hi);
    }
    glyphs.push_back(std::move(glyph));
    pen.x += first ? advance - bearing : advance + kerned.x;
    pen += offset;
    before = index;
    first = false;
  }
  return glyphs;
}

}  // namespace lute
