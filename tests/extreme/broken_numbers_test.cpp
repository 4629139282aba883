// Numbers that no scene should hold: lute rejects what POV-Ray rejects, warns where it warns, at a place in the file,
// and otherwise draws what it draws. It never crashes or hangs.
#include <gtest/gtest.h>

#include <fstream>
#include <ostream>
#include <regex>

#include "compare/difference.hpp"
#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::extreme {
namespace {

struct BrokenScene {
  const char* name;
  const char* statement;
};

void PrintTo(const BrokenScene& scene, std::ostream* out) { *out << scene.name; }

constexpr BrokenScene kScenes[] = {
    {"DivisionByZero", "sphere { 0, 1/0 }"},
    {"DivisionByZeroInADeclare", "#declare X = 1/(2 - 2); sphere { 0, X }"},
    {"DivisionByZeroInAFunction",
     "isosurface { function { x*x + y*y + 0/(z - z) - 1 } contained_by { box { -1, 1 } } }"},
    {"RootOfANegative", "sphere { 0, sqrt(-1) }"},
    {"LogarithmOfZero", "sphere { 0, ln(0) }"},
    {"ArcSineOutOfRange", "sphere { 0, asin(2) }"},
    {"ScaleByZero", "sphere { 0, 1 scale 0 }"},
    {"SingularMatrix", "sphere { 0, 1 matrix <1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0> }"},
    {"NormalisedZeroVector", "sphere { vnormalize(<0, 0, 0>), 1 }"},
    {"RotationAboutAZeroAxis", "sphere { vaxis_rotate(x, <0, 0, 0>, 30), 1 }"},
    {"PlaneWithoutANormal", "plane { <0, 0, 0>, 1 }"},
    {"CylinderWithoutALength", "cylinder { x, x, 1 }"},
    {"ConeWithoutALength", "cone { x, 1, x, 2 }"},
    {"TriangleWithoutAnArea", "triangle { 0, x, 2*x }"},
    {"DiscWithoutANormal", "disc { 0, <0, 0, 0>, 1 }"},
    {"LightOnItsTarget", "light_source { x, rgb 1 spotlight point_at x } sphere { 0, 1 pigment { rgb 1 } }"},
    {"OverflowingPower", "sphere { 0, pow(10, 400) }"},
    {"HugeNumbers", "sphere { 0, 1e300 pigment { rgb 1 } } box { -1e300, 1e300 pigment { rgb 1 } }"},
    {"ModuloZero", "sphere { 0, mod(1, 0) }"},
    {"TorusOfNothing", "torus { 0, 0 }"},
    {"SphereOfNothing", "sphere { 0, 0 }"},
    {"SuperellipsoidOfNothing", "superellipsoid { <0, 0> }"},
    {"CameraInItsTarget", "camera { location 0 look_at 0 }"},
};

struct Rendered {
  int exit_code = -1;
  std::string messages;
  std::filesystem::path picture;
};

class BrokenNumbers : public testing::TestWithParam<BrokenScene> {
 protected:
  void SetUp() override {
    std::ofstream(folder_.path() / "broken.pov") << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
                                                 << "camera { location -5*z }\nbackground { rgb <0, 0, 1> }\n"
                                                 << GetParam().statement << '\n';
  }

  Rendered run(const std::string& program, const char* picture) {
    compare::ProcessRequest request;
    request.arguments = {program, "broken.pov", "+W16", "+H12", std::string("+O") + picture, "-A", "-D"};
    request.working_directory = folder_.path();
    request.standard_error = folder_.path() / "messages";
    request.time_limit = 60;
    const compare::ProcessResult result = compare::run_process(request);
    EXPECT_FALSE(result.timed_out) << program;
    EXPECT_EQ(result.signal, 0) << program;
    std::ifstream file(request.standard_error);
    return {result.exit_code, std::string(std::istreambuf_iterator<char>(file), {}), folder_.path() / picture};
  }

  compare::ScratchFolder folder_;
};

TEST_P(BrokenNumbers, GetTheDiagnosticOrThePictureOfTheReference) {
  const Rendered theirs = run("povray", "reference.png"), ours = run(LUTE_BINARY_DIR "/lute", "lute.png");
  EXPECT_EQ(ours.exit_code, theirs.exit_code) << ours.messages;
  if (std::regex_search(theirs.messages, std::regex("line 5: .*(Warning|Error): "))) {
    EXPECT_NE(ours.messages.find("broken.pov:5:"), std::string::npos) << ours.messages;
  }
  if (ours.exit_code != 0 || theirs.exit_code != 0) return;
  const compare::Difference d =
      compare::difference(compare::read_picture(ours.picture), compare::read_picture(theirs.picture));
  EXPECT_EQ(d.within, 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, BrokenNumbers, testing::ValuesIn(kScenes),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace lute::extreme
