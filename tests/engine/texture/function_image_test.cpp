#include "engine/texture/function_image.hpp"

#include <gtest/gtest.h>

#include "engine/function/program.hpp"

namespace lute {
namespace {

// Columns from 0 to 1 in x, rows in y: what x / 4 + y / 2 gives, times 65535. Rows are longer than what is sampled at once.
TEST(FunctionImage, SamplesEveryPixelOfLongRows) {
  ExpressionBuilder e;
  const auto quarter = e.binary(BinaryOp::kMultiply, e.parameter(0), e.constant(0.25));
  const auto half = e.binary(BinaryOp::kMultiply, e.parameter(1), e.constant(0.5));
  const auto image = sample_function(*e.finish(e.binary(BinaryOp::kAdd, quarter, half), 3), 515, 3);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 515; ++column)
      ASSERT_EQ(image->height_at(column, row), static_cast<std::uint16_t>(static_cast<float>(column / 514.0 * 0.25 + row / 2.0 * 0.5) * 65535.0f))
          << column << ", " << row;
}

}  // namespace
}  // namespace lute
