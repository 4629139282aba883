// The table of primitives against the shapes of the engine: a shape whose line is missing there would be an unknown word.
#include "parser/statement/primitive.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace lute {
namespace {

bool has_parser(std::string_view keyword) {
  return std::ranges::any_of(primitives(), [&](const Primitive& primitive) { return spelling(primitive.word) == keyword; });
}

template <class... Shapes>
void expect_parsers(const SharedVariant<Shapes...>*) {
  for (const std::string_view keyword : {Shapes::kKeyword...}) EXPECT_TRUE(has_parser(keyword)) << keyword;
}

TEST(Primitives, EveryShapeOfTheEngineHasAParser) { expect_parsers(static_cast<const AnyShape*>(nullptr)); }

}  // namespace
}  // namespace lute
