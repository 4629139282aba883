// What stands between objects: settings, defaults, surroundings, the end of the scene (specification chapter 11 §2-5).
#include "tests/parser/read_text.hpp"
#include "tests/parser/statement/scene_text.hpp"

namespace lute::test {
namespace {

TEST(TopLevel, TheFirstAssumedGammaCounts) {
  const Scene scene = scene_of("#version 3.7; global_settings { assumed_gamma 2.2 } global_settings { assumed_gamma 1 }");
  EXPECT_EQ(scene.settings.assumed_gamma, 2.2);
}

TEST(TopLevel, OldScenesWithoutGammaHaveNoGammaHandling) {  // case 26
  EXPECT_EQ(scene_of("sphere { 0, 1 }").settings.gamma_mode, GammaMode::kNone);
  EXPECT_EQ(scene_of("#version 3.7; sphere { 0, 1 }").settings.gamma_mode, GammaMode::kPower);
  EXPECT_EQ(scene_of("sphere { 0, 1 }").effective_version, 362);
}

TEST(TopLevel, TheNoiseGeneratorFollowsTheVersion) {
  EXPECT_EQ(scene_of("#version 3.1; sphere { 0, 1 }").settings.noise_generator, 1);
  EXPECT_EQ(scene_of("#version 3.7; sphere { 0, 1 }").settings.noise_generator, 2);
  EXPECT_EQ(scene_of("#version 3.7; global_settings { noise_generator 3 } #version 3.1; sphere { 0, 1 }").settings.noise_generator, 3);
}

TEST(TopLevel, AnythingElseIsAnError) {
  EXPECT_EQ(rejection_of(kVersion + "rotate x"), "Expected 'object or directive', rotate found instead");
}

TEST(TopLevel, RadiosityAndPhotonsAreCheckedThoughNotRendered) {
  EXPECT_TRUE(warns("global_settings { radiosity { count 50 } }", "radiosity is not rendered yet"));
  EXPECT_NE(rejection_of("global_settings { radiosity { count -1 } }"), "");
  EXPECT_NE(rejection_of("global_settings { radiosity { pretrace_start 0.1 pretrace_end 0.5 } }"), "");
  EXPECT_NE(rejection_of("global_settings { photons { gather 30, 20 } }"), "");
}

TEST(TopLevel, WarnsOfWhatIsNotRenderedAtItsKeyword) {
  const Reading reading = read_text("global_settings { photons { count 50 } }");
  const auto found = std::ranges::find(reading.diagnostics, "photons are not rendered yet", &Diagnostic::message);
  ASSERT_NE(found, reading.diagnostics.end());
  EXPECT_EQ(found->where.line, 2u);
  EXPECT_EQ(found->where.column, 19u);
}

TEST(TopLevel, FogsAccumulateAndTurnTheirUpVector) {
  const Scene scene = scene_of(kVersion + "fog { distance 10 color rgb 1 fog_type 2 rotate 90*z } fog { 5 }");
  ASSERT_EQ(scene.fogs.size(), 2u);
  EXPECT_NEAR(scene.fogs[0].up.x, -1, 1e-12);
  EXPECT_EQ(scene.fogs[1].distance, 5);
}

TEST(TopLevel, RainbowsAreChecked) {
  EXPECT_NE(rejection_of(kVersion + "rainbow { direction 0 }"), "");
  EXPECT_EQ(rejection_of(kVersion + "rainbow { direction z arc_angle 10 falloff_angle 20 }"),
            "Arc angle is smaller than falloff angle in rainbow.");
}

TEST(TopLevel, SkySpherePigmentsAccumulateOnIdentifiers) {
  const Scene scene = scene_of(kVersion + "#declare S = sky_sphere { pigment { rgb 1 } } sky_sphere { S pigment { rgb 0 } rotate x }");
  EXPECT_EQ(scene.sky_sphere->pigments.size(), 2u);
}

TEST(TopLevel, MediaOfIdentifiersKeepsItsValues) {
  const Scene scene = scene_of(kVersion + "#declare M = media { absorption 1 samples 5 } media { M emission 2 }");
  ASSERT_EQ(scene.atmosphere.size(), 1u);
}

}  // namespace
}  // namespace lute::test
