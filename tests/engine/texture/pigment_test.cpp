// Specification chapter 50 §16 C, the pigments: pixel centres x = -1.5 ... 1.5, y = 1, 0, -1.
#include <gtest/gtest.h>

#include <set>

#include "engine/texture/function_image.hpp"
#include "pattern_value.hpp"

namespace lute {
namespace {

Color rgb(float r, float g, float b) { return {{r, g, b}, 0, 0}; }

Gradient gradient_x() {
  Gradient g;
  g.direction = {1, 0, 0};
  return g;
}

Pigment scaled(Pigment pigment, double factor) {
  prepend_transform(pigment.body.warps, Transform::scale(dvec3(factor)));
  return pigment;
}

Color color_at(const Pigment& description, double x, double y, bool* found = nullptr) {
  TextureCompiler compiler{TextureSettings()};
  Color color;
  const bool has_color = compiler.pigment(std::make_shared<Pigment>(description))->evaluate({x, y, 0}, SurfaceContext(), color);
  if (found != nullptr) *found = has_color;
  return color;
}

void expect_rgb(const Color& color, double r, double g, double b, double tolerance = 2e-5) {
  EXPECT_NEAR(static_cast<double>(color.rgb.r), r, tolerance);
  EXPECT_NEAR(static_cast<double>(color.rgb.g), g, tolerance);
  EXPECT_NEAR(static_cast<double>(color.rgb.b), b, tolerance);
}

TEST(Pigment, EqualPositionsMakeAHardStep) {  // C8
  Pigment pigment;
  pigment.body = body_of(gradient_x());
  pigment.map = ColorMap{{{0.2f, rgb(1, 0, 0)}, {0.6f, rgb(0, 1, 0)}, {0.6f, rgb(0, 0, 1)}}};
  pigment = scaled(pigment, 5);
  expect_rgb(color_at(pigment, -1.5, 0), 0, 0, 1);
  expect_rgb(color_at(pigment, -0.5, 0), 0, 0, 1);
  expect_rgb(color_at(pigment, 0.5, 0), 1, 0, 0);
  expect_rgb(color_at(pigment, 1.5, 0), 0.75, 0.25, 0);
}

TEST(Pigment, AverageWeighsItsEntries) {  // C9
  Pigment red, grey_gradient, average;
  red.map = rgb(1, 0, 0);
  grey_gradient.body = body_of(gradient_x());
  grey_gradient = scaled(grey_gradient, 4);
  average.body.pattern = Average{};
  average.map = PigmentMap{{{1, std::make_shared<Pigment>(red)}, {3, std::make_shared<Pigment>(grey_gradient)}}};
  const double expected[4][2] = {{.7187, .4688}, {.9062, .6562}, {.3438, .0938}, {.5312, .2813}};
  for (int i = 0; i < 4; ++i) expect_rgb(color_at(average, i - 1.5, 0), expected[i][0], expected[i][1], expected[i][1], 1e-4);
}

TEST(Pigment, MarbleHasDefaultColors) {  // C16: green and blue
  Pigment marble;
  marble.body = body_of(Marble());
  ClassicTurbulence turbulence;
  turbulence.amount = dvec3(0.5);
  turbulence.octaves = 4;
  marble.body.warps.push_back(turbulence);
  marble = scaled(marble, 2);
  const double expected[3][4] = {{0, .6845, 0, .5284}, {.5776, .7605, 0, .6481}, {.4772, .4259, .5327, .5568}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      EXPECT_NEAR(static_cast<double>(color_at(marble, column - 1.5, 1.0 - row).rgb.g), expected[row][column], 1e-4);
}

TEST(Pigment, ObjectPatternHasDefaultColors) {  // §10.3: outside blue, inside green
  PatternBody body;
  body.pattern = AnyPattern(ObjectPattern());
  const ColorMap& map = default_color_map(body);
  ASSERT_EQ(map.entries.size(), 2u);
  EXPECT_EQ(map.entries[0].value, rgb(0, 0, 1));
  EXPECT_EQ(map.entries[1].value, rgb(0, 1, 0));
}

TEST(Pigment, BrickHasDefaultColors) {  // C17
  Pigment brick;
  brick.body = body_of(Brick());
  brick = scaled(brick, 0.4);
  for (int column = 0; column < 4; ++column) {
    expect_rgb(color_at(brick, column - 1.5, 1), 0.5, 0.5, 0.5);
    expect_rgb(color_at(brick, column - 1.5, 0), 0.6, 0.15, 0.15);
    if (column < 3) expect_rgb(color_at(brick, column - 1.5, -1), 0.6, 0.15, 0.15);
  }
  expect_rgb(color_at(brick, 1.5, -1), 0.5, 0.5, 0.5);
}

// function 4, 4 { pigment { gradient x color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } } }
class Ramp final : public Function {
 public:
  Ramp() : Function(3, 5) {}
  void evaluate(const double* arguments, double* results) const override {
    const double v = arguments[0];
    const double values[5] = {v, 0.5 * v, 0.25 * v, 0, 0};
    std::copy(values, values + 5, results);
  }
};

Pigment image_map(int interpolate, bool once) {
  ImageMap map;
  map.mapping.image = sample_function(Ramp(), 4, 4);
  map.mapping.interpolate = interpolate;
  map.mapping.once = once;
  Pigment pigment;
  pigment.body = body_of(map);
  return scaled(pigment, 5);
}

void expect_row(const Pigment& pigment, double y, const double (&red)[4], double tolerance = 5e-5) {
  for (int i = 0; i < 4; ++i) expect_rgb(color_at(pigment, i - 1.5, y), red[i], red[i] / 2, red[i] / 4, tolerance);
}

TEST(ImageMap, InterpolatesLikeTheReference) {  // C10, C11, C12
  for (const double y : {1.0, 0.0, -1.0}) {
    expect_row(image_map(2, false), y, {.7667, .9000, .1000, .2333});
    expect_row(image_map(3, false), y, {.8087, .9480, .0520, .1913});
  }
  expect_row(image_map(4, false), 1, {.7579, .8645, .1355, .2421});
  expect_row(image_map(4, false), 0, {.7716, .8030, .1970, .2284});
  expect_row(image_map(4, false), -1, {.7579, .8645, .1355, .2421});
}

// The red of POV-Ray at <-1.43, 0>, <-0.43, 0.3>, <0.57, 0.6>, <1.57, 0.9>, printed with twelve digits.
TEST(ImageMap, WeighsLikeTheReferenceToTheLastBit) {
  const float expected[3][4] = {{.785333335400f, .843999981880f, .043999999762f, .252000004053f},
                                {.839745342731f, .904389858246f, .018425088376f, .221993863583f},
                                {.787244737148f, .858799576759f, .003777638078f, .271303266287f}};
  for (int kind = 2; kind <= 4; ++kind)
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(color_at(image_map(kind, false), i - 1.43, 0.3 * i).rgb.r, expected[kind - 2][i]) << kind << ' ' << i;
}

// Measured with the reference: 16 bits of the integer count, of values that 32 bits hold.
TEST(FunctionImage, ValuesOutsideWrapAround) {
  class Constant final : public Function {
   public:
    explicit Constant(double value) : Function(3, 1), value_(value) {}
    void evaluate(const double*, double* results) const override { results[0] = value_; }

   private:
    double value_;
  };
  const auto stored = [](double v) { return sample_function(Constant(v), 1, 1)->height_at(0, 0); };
  EXPECT_EQ(stored(0.5), 32767);
  EXPECT_EQ(stored(-1), 1);
  EXPECT_EQ(stored(2), 65534);
  EXPECT_EQ(stored(1e10), 0);
  EXPECT_EQ(stored(std::nan("")), 0);
}

TEST(ImageMap, OnceHasNoColorOutside) {  // C13
  bool found = true;
  color_at(image_map(0, true), -1.5, 1, &found);
  EXPECT_FALSE(found);
  color_at(image_map(0, true), 1.5, -1, &found);
  EXPECT_FALSE(found);
  expect_rgb(color_at(image_map(0, true), 0.5, 1, &found), 0, 0, 0);
  EXPECT_TRUE(found);
  EXPECT_NEAR(static_cast<double>(color_at(image_map(0, true), 1.5, 0, &found).rgb.r), 1.0 / 3, 2e-5);
  EXPECT_TRUE(found);
}

TEST(ImageMap, OnceCountsAsClearInsideAMap) {  // §11.1
  Pigment outer;
  outer.body = body_of(gradient_x());
  outer.map = PigmentMap{{{0, std::make_shared<Pigment>(image_map(0, true))}}};
  bool found = false;
  const Color color = color_at(outer, -1.5, 1, &found);
  EXPECT_TRUE(found);
  EXPECT_EQ(color, (Color{Rgb(1), 0, 1}));
}

// Indices 0 and 3, of which the interpolated one is truncated: measured with a palette of 16 random colours, whose numbers of textures are
// those of POV-Ray at all of 1728 pixels, with each interpolation.
TEST(MaterialMap, InterpolatesIndices) {  // §11.6
  MaterialMap map;
  const std::vector<Image::Pixel> palette(4, Image::Pixel{{0.9f, 0.5f, 0.1f}});
  map.mapping.image = std::make_shared<Image>(2, 1, std::vector<std::uint8_t>{0, 3}, palette);
  map.texture_count = 10;
  EXPECT_EQ(value_at(body_of(map), {0.49, 0.5, 0}), 0);
  EXPECT_EQ(value_at(body_of(map), {0.51, 0.5, 0}), 3);
  map.mapping.interpolate = 2;  // 6 (x - 1/4)
  EXPECT_EQ(value_at(body_of(map), {0.40, 0.5, 0}), 0);
  EXPECT_EQ(value_at(body_of(map), {0.42, 0.5, 0}), 1);
  EXPECT_EQ(value_at(body_of(map), {0.59, 0.5, 0}), 2);
  map.texture_count = 2;
  EXPECT_EQ(value_at(body_of(map), {0.7499, 0.5, 0}), 2);  // 2 is not above 2
  map.texture_count = 1;
  EXPECT_EQ(value_at(body_of(map), {0.7499, 0.5, 0}), 0);  // 2 mod 1
}

// All pixels of a picture of 4 by 4 have the index 100; the weights add up to 1 but for their rounding, and the mean is truncated. Positions of
// 40 by 40 pixels of a picture and what POV-Ray 3.7.0.10 takes there; it does so at all 1600 of them with each interpolation.
TEST(MaterialMap, WeighsLikeTheReferenceToTheLastBit) {
  MaterialMap map;
  map.mapping.image = std::make_shared<Image>(4, 4, std::vector<std::uint8_t>(16, 100), std::vector<Image::Pixel>(256));
  struct Case {
    int interpolate;
    dvec2 position;
    int index;
  };
  const Case cases[] = {{2, {0.65000000010000003, 0.54999999989999981}, 100},
                        {2, {1.1500000001000001, 0.54999999989999981}, 100},
                        {2, {1.6500000001000001, 0.54999999989999981}, 100},
                        {2, {3.1500000001000004, 2.6499999998999999}, 99},
                        {2, {2.1500000000999999, 3.3499999999000001}, 99},
                        {3, {0.65000000010000003, 0.54999999989999981}, 100},
                        {3, {1.1500000001000001, 0.54999999989999981}, 100},
                        {3, {1.6500000001000001, 0.54999999989999981}, 100},
                        {3, {2.1500000000999999, 0.54999999989999981}, 99},
                        {3, {2.1500000000999999, 1.2499999999}, 99},
                        {3, {3.1500000001000004, 1.2499999999}, 99},
                        {4, {0.65000000010000003, 0.54999999989999981}, 100},
                        {4, {1.1500000001000001, 0.54999999989999981}, 100},
                        {4, {1.6500000001000001, 0.54999999989999981}, 100},
                        {4, {2.1500000000999999, 0.54999999989999981}, 99},
                        {4, {3.1500000001000004, 0.54999999989999981}, 99},
                        {4, {1.6500000001000001, 1.2499999999}, 99}};
  for (const Case& c : cases) {
    map.mapping.interpolate = c.interpolate;
    const double mean = interpolate_pixels(map.mapping, c.position, [](int, int) { return 100.0; });
    EXPECT_EQ(static_cast<int>(mean), c.index) << c.interpolate << ' ' << c.position.x << ' ' << c.position.y;
  }
}

// Without a palette the number is that of red, which is 100 here; with an index of its own, -1, weighed beside it, it is 0 where the weights add up
// to less than 1: so POV-Ray 3.7.0.10 has it, too.
TEST(MaterialMap, ColorsWithoutPaletteCountByRed) {
  std::vector<float> codes(256);
  for (std::size_t i = 0; i < 256; ++i) codes[i] = static_cast<float>(i) / 255.0f;
  MaterialMap map;
  map.mapping.image = std::make_shared<Image>(4, 4, 3, std::vector<std::uint8_t>(48, 100), codes);
  map.texture_count = 256;
  EXPECT_EQ(value_at(body_of(map), {0.3, 0.6, 0}), 100);
  map.mapping.interpolate = 3;
  int without = 0;
  for (int i = 0; i < 100; ++i) {
    const double number = value_at(body_of(map), {0.00731 * i, 0.00377 * i, 0});
    EXPECT_TRUE(number == 0 || number == 100) << number;
    without += number == 0 ? 1 : 0;
  }
  EXPECT_GT(without, 20);  // 685 of 1600 in the reference
  EXPECT_LT(without, 70);
}

TEST(DensityFile, InterpolatesLikeTheReference) {  // C15
  std::string error;
  const auto volume = DensityVolume::parse({0, 3, 0, 1, 0, 1, 0, 255, 51}, error);
  ASSERT_NE(volume, nullptr) << error;
  const double expected[3][4] = {{0, 1, 1, .2}, {.375, .9, .3, .075}, {.38087, .98202, .28359, 0}};
  for (int kind = 0; kind < 3; ++kind) {
    DensityFile pattern;
    pattern.volume = volume;
    pattern.interpolate = kind;
    PatternBody body = body_of(pattern);
    prepend_transform(body.warps, Transform::translate({-0.5, -0.5, 0}));
    prepend_transform(body.warps, Transform::scale(dvec3(4)));
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(value_at(body, {i - 1.5, 0, 0}), expected[kind][i], 2e-5) << kind << ' ' << i;
  }
}

TEST(DensityFile, WrongSizeIsAnError) {
  std::string error;
  EXPECT_EQ(DensityVolume::parse({0, 3, 0, 1, 0, 1, 0, 255}, error), nullptr);
  EXPECT_EQ(error, "Invalid density file size");
}

// Indices 0 and 3, of which the interpolated one is truncated: measured with a palette of 16 colours, 99.99 % of the pixels of a ball.
TEST(BumpMap, HasWholeIndicesBetweenPixels) {
  BumpMap map;
  map.mapping.image = std::make_shared<Image>(2, 1, std::vector<std::uint8_t>{0, 3}, std::vector<Image::Pixel>(4));
  map.mapping.interpolate = 2;
  map.mapping.use_index = true;
  std::set<double> heights;
  for (int i = 0; i < 100; ++i) heights.insert(evaluate(map, {i / 100.0, 0.5, 0}, PatternContext()));
  EXPECT_EQ(heights, (std::set<double>{0, 1, 2}));
}

TEST(BumpMap, EqualsTheReference) {  // C14
  BumpMap map;
  map.mapping.image = sample_function(Ramp(), 4, 4);
  map.mapping.interpolate = 2;
  Normal description;
  description.body = body_of(map);
  description.amount = 2;
  prepend_transform(description.body.warps, Transform::scale(dvec3(5)));
  TextureCompiler compiler{TextureSettings()};
  const CompiledNormal* normal = compiler.normal(std::make_shared<Normal>(description), false);
  const double expected[4] = {.90779, .78917, .78917, .90779};
  for (int i = 0; i < 4; ++i) {
    const dvec3 n = normal->perturb({0, 0, -1}, {i - 1.5, 0, 0}, SurfaceContext());
    EXPECT_NEAR(std::acos(n.z) / kPi, expected[i], 2e-5);
  }
}

}  // namespace
}  // namespace lute
