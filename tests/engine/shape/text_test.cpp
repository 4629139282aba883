// Expected numbers: specification chapter 21 §12, check case 13. The fonts are those of the installed povray-includes.
#include "engine/shape/text.hpp"

#include <gtest/gtest.h>

#include "tests/file_text.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using test::trace;

std::shared_ptr<const std::string> font(const std::string& name) {
  return std::make_shared<const std::string>(test::file_text("/usr/share/povray-3.7/include/" + name));
}

class TextTest : public testing::Test {
 protected:
  void SetUp() override {
    if (font("timrom.ttf")->empty()) GTEST_SKIP() << "povray-includes is not installed";
  }

  static Aabb bounds(const std::string& name, std::u16string string, double depth, const dvec3& offset) {
    return make(Text{font(name), std::move(string), depth, offset})->bounds();
  }
};

void expect_corner(const dvec3& corner, double x, double y, double z) {
  EXPECT_NEAR(corner.x, x, 6e-4);
  EXPECT_NEAR(corner.y, y, 6e-4);
  EXPECT_NEAR(corner.z, z, 6e-4);
}

TEST_F(TextTest, LaysOutCharacters) {
  expect_corner(bounds("timrom.ttf", u"A", 1, dvec3(0)).hi, .736, .696, 1);
  expect_corner(bounds("timrom.ttf", u"AV", .5, {.1, .2, 0}).hi, 1.378, .880, .5);
  expect_corner(bounds("timrom.ttf", u"III", .5, {.1, .2, .3}).hi, 1.180, 1.080, .5);
  const Aabb kerned = bounds("timrom.ttf", u"To", 1, dvec3(0));
  EXPECT_NEAR(kerned.hi.x, 1.012, 6e-4);
  EXPECT_NEAR(kerned.lo.y, -.010, 6e-4);
  expect_corner(bounds("cyrvetic.ttf", u"B", 1, dvec3(0)).hi, .534, .728, 1);
  expect_corner(bounds("crystal.ttf", u"B", 1, dvec3(0)).hi, .376971, .675788, 1);
  expect_corner(bounds("povlogo.ttf", u"B", 1, dvec3(0)).hi, .669939, 1.001965, 1);
}

TEST_F(TextTest, IsTurnedByAThousandthOfADegree) {
  const auto shape = make(Text{font("timrom.ttf"), u"I", 1, dvec3(0)});
  EXPECT_TRACE(*shape, dvec3(.15, .3, -5), dvec3(0, 0, 1), dvec3(.15, .3, 0.000003), dvec3(-0.000017, 0.000017, -1));
}

// Both faces lie in one place; of equal depths the last one counts, the back, whose normal points away. Measured with POV-Ray: the
// interior texture shows.
TEST_F(TextTest, WithoutDepthShowsItsBack) {
  const auto shape = make(Text{font("timrom.ttf"), u"I", 0, dvec3(0)});
  const auto traced = trace(*shape, {.15, .3, -5}, {0, 0, 1});
  ASSERT_TRUE(traced);
  EXPECT_NEAR(traced->normal.z, 1, 1e-6);
}

TEST_F(TextTest, HolesAreOutside) {
  const auto shape = make(Text{font("timrom.ttf"), u"O", 1, dvec3(0)});
  const Aabb box = shape->bounds();
  const dvec3 middle = box.center();
  EXPECT_FALSE(shape->inside(middle));
  EXPECT_TRUE(shape->inside({box.lo.x + .05, middle.y, .5}));
  ShapeHits hits;
  shape->hits({{-1, middle.y, .5}, {1, 0, 0}}, {1e-4, 100}, hits);
  EXPECT_EQ(hits.size(), 4u);
}

// Measured with POV-Ray's trace(): where rays toward -x at z = 0.05 meet the right of the glyph. Between two control points the curve
// passes through their exact middle, not through the nearest whole font unit.
TEST_F(TextTest, ImpliedPointsLieExactlyInTheMiddle) {
  const auto eight = make(Text{font("cyrvetic.ttf"), u"8", .1, dvec3(0)});
  const auto s = make(Text{font("timrom.ttf"), u"S", .1, dvec3(0)});
  const auto right = [](const Shape& shape, double y) { return trace(shape, dvec3(2, y, .05), dvec3(-1, 0, 0))->point.x; };
  EXPECT_NEAR(right(*eight, .7), .3032445, 1e-7);
  EXPECT_NEAR(right(*eight, .3), .4547150, 1e-7);
  EXPECT_NEAR(right(*s, .3), .3905442, 1e-7);
}

}  // namespace
}  // namespace lute
