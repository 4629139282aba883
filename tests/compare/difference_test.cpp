#include "compare/difference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

Picture grey(int width, int height, float value) {
  Picture picture(width, height);
  for (std::size_t i = 0; i < picture.values.size(); ++i) picture.values[i] = i % 4 == 3 ? 1.0f : value;
  return picture;
}

TEST(Difference, EqualPicturesHaveNoDifferenceAndInfinitePsnr) {
  const Difference d = difference(grey(20, 10, 0.5f), grey(20, 10, 0.5f));
  EXPECT_EQ(d.maximum, 0);
  EXPECT_EQ(d.rmse, 0);
  EXPECT_EQ(d.within, 1);
  EXPECT_TRUE(std::isinf(d.psnr));
}

TEST(Difference, ExactlyTheToleranceIsWithinAndOneMoreIsNot) {
  EXPECT_EQ(difference(grey(8, 8, 100 / 255.0f), grey(8, 8, 102 / 255.0f)).within, 1);
  EXPECT_EQ(difference(grey(8, 8, 100 / 255.0f), grey(8, 8, 103 / 255.0f)).within, 0);
}

TEST(Difference, OneChannelOfOnePixelCounts) {
  const Picture a = grey(10, 10, 0);
  Picture b = a;
  b.at(3, 4)[1] = 1;
  const Difference d = difference(a, b);
  EXPECT_DOUBLE_EQ(d.within, 0.99);
  EXPECT_DOUBLE_EQ(d.maximum, 1);
  EXPECT_DOUBLE_EQ(d.mean, 1.0 / 300);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(1.0 / 300));
  EXPECT_NEAR(d.psnr, 10 * std::log10(300), 1e-9);
}

TEST(Difference, BlockFigureForgivesNoiseAndFindsShifts) {
  Picture noisy = grey(64, 64, 0.5f);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) noisy.at(x, y)[0] += (x + y) % 2 == 0 ? 0.1f : -0.1f;
  }
  EXPECT_NEAR(difference(noisy, grey(64, 64, 0.5f)).block98_255, 0, 1e-3);
  EXPECT_NEAR(difference(grey(64, 64, 0.4f), grey(64, 64, 0.5f)).block98_255, 25.5, 1e-3);
}

TEST(Difference, TransparencyIsAFourthChannel) {
  const Picture a = grey(4, 4, 1);
  Picture b = a;
  for (std::size_t i = 3; i < b.values.size(); i += 4) b.values[i] = 0.5f;
  const Difference d = difference(a, b);
  EXPECT_TRUE(d.alpha_compared);
  EXPECT_DOUBLE_EQ(d.rmse, 0.25);
}

TEST(Difference, NotANumberInOnePictureCountsAsOne) {
  const Picture a = grey(2, 2, 0.5f);
  Picture b = a;
  b.at(0, 0)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_DOUBLE_EQ(difference(a, b).maximum, 1);
  EXPECT_DOUBLE_EQ(difference(b, b).maximum, 0);
}

TEST(Difference, SizesMustAgree) { EXPECT_THROW(difference(grey(2, 2, 0), grey(2, 3, 0)), std::runtime_error); }

TEST(Picture, SurvivesWritingAndReading) {
  const ScratchFolder folder;
  Picture a = grey(5, 3, 0);
  for (int x = 0; x < 5; ++x) a.at(x, 1)[2] = static_cast<float>(x * 51) / 255.0f;
  write_picture(a, folder.path() / "sub" / "a.png");
  EXPECT_LT(difference(a, read_picture(folder.path() / "sub" / "a.png")).maximum, 1e-6);
}

TEST(Picture, MissingFileIsAnErrorWithItsName) {
  try {
    read_picture("/nowhere/a.png");
    FAIL() << "read a file that does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/a.png"), std::string::npos);
  }
}

TEST(HeatMap, IsBlackWhereEqualAndWhiteWhereFar) {
  Picture a = grey(2, 1, 0);
  Picture b = a;
  b.at(1, 0)[0] = 1;
  const Picture map = heat_map(a, b);
  EXPECT_EQ(map.at(0, 0)[0], 0);
  EXPECT_EQ(map.at(1, 0)[0], 1);
  EXPECT_EQ(map.at(1, 0)[2], 1);
}

}  // namespace
}  // namespace lute::compare
