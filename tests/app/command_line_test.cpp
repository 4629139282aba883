#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lute_run.hpp"

namespace lute {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kPng = "\x89PNG";

using CommandLine = LuteFolder;

// Specification chapter 30 §12 M: POV-Ray exits with 1 for all of these.
TEST_F(CommandLine, AsPovrayMistakesInOptionsExitWithOne) {
  fs::create_symlink(LUTE_BINARY_DIR "/lute", path("povray"));
  for (const char* mistake : {"+A1", "+Qx", "+FX", "+ZZ", "Foo=5", "+FN16x"}) {
    EXPECT_EQ(run_lute({path("small.pov"), mistake}, "", 0, path("povray")).exit_code, 1) << mistake;
    EXPECT_EQ(run_lute({path("small.pov"), mistake}).exit_code, 2) << mistake;
  }
}

TEST_F(CommandLine, MistakesBehindASwitchAreToldOfTheLongestSwitch) {
  EXPECT_THAT(run_lute({path("small.pov"), "+AEnan"}).error, HasSubstr("'+AE' takes a number"));
  EXPECT_THAT(run_lute({path("small.pov"), "+AMx"}).error, HasSubstr("'+AM' takes a whole number"));
  EXPECT_THAT(run_lute({path("small.pov"), "+A1"}).error, HasSubstr("'+A' takes nothing or a number like 0.3"));
  EXPECT_THAT(run_lute({path("small.pov"), "+AE99"}).error, HasSubstr("above 0 and at most 1"));
  EXPECT_EQ(run_lute({path("small.pov"), "+AE1", "+W4", "+H3"}).exit_code, 0);
}

TEST_F(CommandLine, HelpAndVersionGoToStandardOutput) {
  const LuteRun help = run_lute({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("--antialias"));
  const LuteRun version = run_lute({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, StartsWith("lute "));
}

TEST_F(CommandLine, MistakesInOptionsExitWithTwo) {
  const LuteRun unknown = run_lute({"--heigth", "5", path("small.pov")});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.error, HasSubstr("did you mean '--height'?"));
  EXPECT_EQ(run_lute({}).exit_code, 2);
  EXPECT_EQ(run_lute({path("small.pov"), "+W0", "+H5"}).exit_code, 2);
}

TEST_F(CommandLine, MissingSceneIsToldAtOnce) {
  const LuteRun run = run_lute({path("missing.pov")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.error, HasSubstr("missing.pov"));
  EXPECT_LT(run.seconds, 1.0);
}

TEST_F(CommandLine, RendersBesideTheScene) {
  const LuteRun run = run_lute({path("small.pov"), "+W32", "+H24"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_THAT(content("small.png"), StartsWith(kPng));
  EXPECT_THAT(run.error, HasSubstr("small.png"));
}

TEST_F(CommandLine, QuietSaysNothing) {
  const LuteRun run = run_lute({path("small.pov"), "+W32", "+H24", "-V"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.error, "");
}

TEST_F(CommandLine, DashIsStandardInputAndOutput) {
  const LuteRun run = run_lute({"-", "+O-", "+W16", "+H12"}, kSmallScene);
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_THAT(run.out, StartsWith(kPng));
  EXPECT_THAT(files(), ElementsAre("small.pov"));
}

TEST_F(CommandLine, BrokenSceneLeavesNoFile) {
  write("broken.pov", "sphere { 0, 1 pigmentt { rgb 1 } }\n");
  const LuteRun run = run_lute({path("broken.pov"), "+W16", "+H12"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.error, HasSubstr("broken.pov:1:"));
  EXPECT_THAT(files(), ElementsAre("broken.pov", "small.pov"));
}

TEST_F(CommandLine, ProblemsOfTheCallAreJsonToo) {
  const LuteRun usage = run_lute({path("small.pov"), "+Zfoo", "--diagnostics=json"});
  EXPECT_EQ(usage.exit_code, 2);
  EXPECT_THAT(usage.out, HasSubstr("\"code\":\"usage\""));
  const LuteRun place = run_lute({path("small.pov"), "+O" + path("missing/a.png"), "--diagnostics=json"});
  EXPECT_EQ(place.exit_code, 1);
  EXPECT_THAT(place.out, HasSubstr("cannot write"));
  EXPECT_THAT(usage.error + place.error, Not(HasSubstr("error")));
}

TEST_F(CommandLine, UnwritableOutputIsToldBeforeRendering) {
  const LuteRun run = run_lute({path("small.pov"), "+W4000", "+H4000", "+O" + path("missing/a.png")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.error, HasSubstr("cannot write"));
  EXPECT_LT(run.seconds, 1.0);
}

TEST_F(CommandLine, InterruptedRenderLeavesTheOldPicture) {
  write("small.png", "old");
  const LuteRun run = run_lute({path("small.pov"), "+W8000", "+H8000", "+A0.01", "+R9", "+WT2"}, "", 0.5);
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_EQ(content("small.png"), "old");
  EXPECT_THAT(files(), ElementsAre("small.png", "small.pov"));
}

// A single block of this picture takes minutes: every pixel is a hall of mirrors.
TEST_F(CommandLine, InterruptStopsInTheMiddleOfAPixel) {
  write("mirrors.pov",
        "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 256 adc_bailout 0 }\n"
        "camera { location 0 }\n"
        "#declare I = 0; #while (I < 60)\n"
        "  sphere { 0, 1 + I pigment { rgbt 1 } finish { reflection 0.9 ambient 0.1 } interior { ior 1.5 } }\n"
        "#declare I = I + 1; #end\n");
  for (const char* threads : {"+WT1", "+WT3"}) {
    const LuteRun run = run_lute({path("mirrors.pov"), "+W32", "+H32", "-A", threads}, "", 0.5);
    EXPECT_EQ(run.exit_code, 130);
    EXPECT_THAT(run.error, HasSubstr("interrupted"));
    EXPECT_LT(run.seconds, 2.0);
  }
}

TEST_F(CommandLine, PicturesAreBitIdenticalForAnyNumberOfThreads) {
  for (const char* threads : {"1", "2", "7"}) {
    const LuteRun run =
        run_lute({path("small.pov"), "+W150", "+H110", "+A0.1", std::string("+WT") + threads, "+O" + path(threads)});
    ASSERT_EQ(run.exit_code, 0) << run.error;
  }
  EXPECT_EQ(content("1.png"), content("2.png"));
  EXPECT_EQ(content("1.png"), content("7.png"));
}

// glibc takes its sine, power and so on from other code where the processor fuses multiplications and additions, and their last bits
// differ; no picture may show it. (Our own vector code is held to the same bits by the tests of the engine.)
TEST_F(CommandLine, PicturesAreBitIdenticalWithoutFusedInstructions) {
  constexpr const char* kTunables = "GLIBC_TUNABLES";
  for (const char* scene : {"shape/isosurface_functions", "shape/julia_fractal_hypercomplex_sin", "shape/superellipsoid", "shape/torus",
                            "pattern/fractals", "pattern/spiral1", "pattern/ripples", "pattern/warp", "light/spotlight", "finish/irid"}) {
    const std::string file = std::string(LUTE_SOURCE_DIR) + "/scenes/feature/" + scene + ".pov";
    const auto rendered = [&](const char* name) {
      const LuteRun run = run_lute({file, "+W100", "+H75", "-A", "+FN16", "+O" + path(name)});
      EXPECT_EQ(run.exit_code, 0) << run.error;
      return content(name);
    };
    const std::string fused = rendered("fused.png");
    setenv(kTunables, "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable,-FMA4", 1);
    const std::string plain = rendered("plain.png");
    unsetenv(kTunables);
    EXPECT_TRUE(fused == plain) << scene;
  }
}

TEST_F(CommandLine, WorksUnderTheNamePovray) {
  fs::create_symlink(LUTE_BINARY_DIR "/lute", folder_ / "povray");
  const LuteRun run =
      run_lute({"+I" + path("small.pov"), "+O" + path("p.png"), "+W16", "+H12", "-D", "-GA", "+WT1", "-P"}, "", 0,
               path("povray"));
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_THAT(content("p.png"), StartsWith(kPng));
}

TEST_F(CommandLine, AnimationWritesEveryFrame) {
  const LuteRun run = run_lute({path("small.pov"), "+W8", "+H6", "+KFF3"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_THAT(files(), ElementsAre("small.pov", "small1.png", "small2.png", "small3.png"));
}

TEST_F(CommandLine, ContinueSkipsWhatIsThere) {
  write("small.png", "old");
  EXPECT_EQ(run_lute({path("small.pov"), "+W8", "+H6", "+C"}).exit_code, 0);
  EXPECT_EQ(content("small.png"), "old");
}

TEST_F(CommandLine, CheckReadsOnly) {
  EXPECT_EQ(run_lute({"--check", path("small.pov")}).exit_code, 0);
  EXPECT_THAT(files(), ElementsAre("small.pov"));
}

TEST_F(CommandLine, DiagnosticsAsJson) {
  write("broken.pov", "sphere { 0, 1\n  nonsense }\n");
  const LuteRun run = run_lute({"--check", "--diagnostics=json", path("broken.pov")});
  EXPECT_EQ(run.exit_code, 1);
  const auto diagnostics = nlohmann::json::parse(run.out);
  ASSERT_FALSE(diagnostics.empty());
  EXPECT_EQ(diagnostics.back()["severity"], "error");
  EXPECT_EQ(diagnostics.back()["line"], 2);
}

TEST_F(CommandLine, ExplainNamesWhatTheSceneNeeds) {
  const LuteRun run = run_lute({"--explain", path("small.pov")});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_THAT(run.out, HasSubstr("needed because"));
}

TEST_F(CommandLine, StatisticsCountRays) {
  const LuteRun run = run_lute({"--stats", path("small.pov"), "+W16", "+H12"});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_THAT(run.error, HasSubstr("192"));  // camera rays
}

TEST_F(CommandLine, StatisticsEstimateTheErrorForEveryMethodAndMethodThreeSaysItAlways) {
  for (const char* antialias : {"-A", "+A0.3", "+AM2", "+AM3"}) {
    const LuteRun run = run_lute({"--stats", path("small.pov"), "+W16", "+H12", antialias});
    EXPECT_THAT(run.error, HasSubstr("root mean square of coded values")) << antialias;
  }
  EXPECT_THAT(run_lute({path("small.pov"), "+W16", "+H12", "+AM3"}).error, HasSubstr("estimated error 0.0"));
  EXPECT_THAT(run_lute({path("small.pov"), "+W16", "+H12", "+A"}).error, testing::Not(HasSubstr("estimated error")));
}

TEST_F(CommandLine, DumpsTokensAndScene) {
  EXPECT_THAT(run_lute({"--dump-tokens", path("small.pov")}).out, HasSubstr("sphere"));
  const LuteRun scene = run_lute({"--dump-scene", path("small.pov")});
  EXPECT_EQ(scene.exit_code, 0) << scene.error;
  EXPECT_FALSE(nlohmann::json::parse(scene.out).empty());
}

TEST_F(CommandLine, BinaryRubbishIsAnErrorNotACrash) {
  std::string rubbish;
  std::uint32_t state = 1;
  for (int i = 0; i < 1'000'000; ++i)
    rubbish.push_back(static_cast<char>((state = state * 1664525u + 1013904223u) >> 24));
  write("rubbish.pov", rubbish);
  const LuteRun run = run_lute({path("rubbish.pov"), "+W8", "+H6"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_LT(run.seconds, 1.0);
}

}  // namespace
}  // namespace lute
