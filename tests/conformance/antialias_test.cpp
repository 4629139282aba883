// Antialiasing by methods 1 and 2 takes the samples that POV-Ray takes, and gives its picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>

#include "compare/difference.hpp"
#include "compare/match.hpp"
#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

struct Case {
  const char* name;
  const char* scene;
  std::vector<std::string> switches;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

struct Rendered {
  Picture picture;
  double samples = 0;  // a pixel
};

class Antialiased : public testing::TestWithParam<Case> {
 protected:
  static constexpr int kWidth = 160, kHeight = 120;

  // What the program says while it renders, with carriage returns as line ends.
  std::string run(const std::string& program, std::vector<std::string> more, const std::filesystem::path& picture) {
    ProcessRequest request;
    request.arguments = {program, std::string(LUTE_SOURCE_DIR) + "/scenes/" + GetParam().scene};
    for (const std::string& word : GetParam().switches) more.push_back(word);
    more.insert(more.end(), {"+W160", "+H120", "+WT1", "-D", "+O" + picture.string()});
    request.arguments.insert(request.arguments.end(), more.begin(), more.end());
    request.standard_error = folder_.path() / "messages";
    request.time_limit = 120;
    EXPECT_TRUE(run_process(request).succeeded()) << program;
    std::ifstream file(request.standard_error);
    std::string text(std::istreambuf_iterator<char>(file), {});
    std::replace(text.begin(), text.end(), '\r', '\n');
    return text;
  }

  Rendered reference() {
    const std::filesystem::path picture = folder_.path() / "reference.png";
    std::istringstream lines(run("povray", {}, picture));
    // "Pixels: 20440   Samples: 13338   Smpls/Pxl: 0.65": the samples of the base grid, and those of antialiasing.
    for (std::string line; std::getline(lines, line);) {
      double pixels = 0, samples = 0;
      if (std::sscanf(line.c_str(), "Pixels: %lf Samples: %lf", &pixels, &samples) == 2)
        return {read_picture(picture), (pixels + samples) / (kWidth * kHeight)};
    }
    ADD_FAILURE() << "POV-Ray printed no statistics";
    return {};
  }

  Rendered lute() {
    const std::filesystem::path picture = folder_.path() / "lute.png";
    std::istringstream lines(run(LUTE_BINARY_DIR "/lute", {"--stats"}, picture));
    for (std::string line; std::getline(lines, line);) {
      double rays = 0;
      if (std::sscanf(line.c_str(), " camera %lf", &rays) == 1)
        return {read_picture(picture), rays / (kWidth * kHeight)};
    }
    ADD_FAILURE() << "lute printed no statistics";
    return {};
  }

  ScratchFolder folder_;
};

TEST_P(Antialiased, TakesTheSamplesOfTheReference) {
  const Rendered theirs = reference(), ours = lute();
  EXPECT_NEAR(ours.samples, theirs.samples, 0.02 * theirs.samples);
  const Difference d = difference(ours.picture, theirs.picture);
  EXPECT_TRUE(matches(d, std::nullopt)) << "within 2/255: " << d.within << ", RMSE: " << d.rmse;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& [name, scene] :
       {std::pair{"Lute", "showcase/lute.pov"}, std::pair{"Refraction", "lecture/refraction.pov"},
        std::pair{"Brick", "lecture/brick.pov"}}) {
    all.push_back({name, scene, {"+A0.3"}});
    all.push_back({name, scene, {"+AM2", "+A0.1", "+R3"}});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Antialiased, testing::ValuesIn(cases()), [](const auto& test) {
  return std::string(test.param.name) + (test.param.switches.size() == 1 ? "MethodOne" : "MethodTwo");
});

}  // namespace
}  // namespace lute::compare
