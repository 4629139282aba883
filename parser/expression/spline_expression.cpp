// spline { [SPLINE] [type] t0, V0 ... }. Source: specification chapter 10 §10.
#include "parser/expression/recorder.hpp"

namespace lute {

std::optional<SplineKind> spline_kind(Word word) {
  switch (word) {
    case Word::kLinearSpline: return SplineKind::kLinear;
    case Word::kQuadraticSpline: return SplineKind::kQuadratic;
    case Word::kCubicSpline: return SplineKind::kCubic;
    case Word::kNaturalSpline: return SplineKind::kNatural;
    default: return std::nullopt;
  }
}

SplinePtr parse_spline(Session& session) {
  Reader& reader = session.reader;
  const TokenStream::AfterOperand allowed(session.stream, true);
  reader.open(Word::kSpline);
  auto spline = std::make_shared<Spline>();
  const Item& next = reader.peek();
  if (next.is(TokenKind::kIdentifier) && next.slot->holds<SplinePtr>()) {
    // The base of a copy, unless it is called: then it is the first parameter value.
    const Item item = reader.take();
    if (session.stream.at_written(TokenKind::kLeftParen)) {
      session.stream.put_back(item);
    } else {
      *spline = **item.slot->get_if<SplinePtr>();
      reader.comma();
    }
  }
  if (const auto kind = spline_kind(reader.word())) {
    reader.take();
    spline->kind = *kind;
  }
  reader.comma();
  // Components that a point leaves out keep what the point before it in the text had.
  Spline::Point point{};
  while (reader.at_number()) {
    const double t = reader.number();
    reader.comma();
    Number value = evaluate(session, Level::kFull);
    if (value.count < 2) value = promoted(session, value, 2);
    for (std::size_t k = 0; k < static_cast<std::size_t>(value.count); ++k) point[k] = value.c[k];
    spline->components = std::max(spline->components, value.count);
    spline->insert(t, point);
    reader.comma();
  }
  if (spline->size() == 0) session.fail("Spline must have at least one entry.", "spline");
  reader.close(Word::kSpline);
  session.spline_used = true;
  return spline;
}

}  // namespace lute
