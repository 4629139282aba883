// Pigments, normals, finishes and maps (specification chapter 11 §9-10).
#include "tests/parser/statement/scene_text.hpp"

namespace lute::test {
namespace {

const Pigment& pigment_of(const Scene& scene) { return *layer(only_object(scene), 0).pigment; }
const Finish& finish_of(const Scene& scene) { return *layer(only_object(scene), 0).finish; }

template <class Pattern>
const Pattern& pattern_of(const PatternBody& body) {
  return std::get<Pattern>(std::get<AnyPattern>(body.pattern));
}

TEST(Pigments, WhatIsNotWrittenStaysAsTheDefaultHasIt) {  // case 3
  const Scene scene = scene_of(
      kVersion + "#default { pigment { gradient x scale 4 } } plane { z, 0 pigment { color_map { [0 rgb x] [1 rgb z] } } }");
  const Pigment& pigment = pigment_of(scene);
  EXPECT_EQ(pattern_of<Gradient>(pigment.body).direction, dvec3(1, 0, 0));
  EXPECT_EQ(pigment.body.warps.size(), 1u);
  EXPECT_EQ(std::get<ColorMap>(pigment.map).entries.size(), 2u);
}

TEST(Pigments, OldMapEntriesStandForTwo) {  // case 4
  const Scene scene = scene_of(kVersion +
                               "plane { z, 0 pigment { gradient x color_map { [0.0 0.5 color rgb x color rgb y] [0.5 1.0 color rgb z "
                               "color rgb 1] } } }");
  const auto& entries = std::get<ColorMap>(pigment_of(scene).map).entries;
  ASSERT_EQ(entries.size(), 4u);
  EXPECT_FLOAT_EQ(entries[1].position, 0.5f);
  EXPECT_EQ(entries[1].value.rgb, Rgb(0, 1, 0));
}

TEST(Pigments, MapColorsNeedAColorWord) {
  EXPECT_THAT(rejection_of(kVersion + "sphere { 0, 1 pigment { gradient x color_map { [0 <1, 0, 0>] } } }"),
              testing::HasSubstr("Expected 'color'"));
}

TEST(Pigments, ListsAreFilledWithTheDefaultColors) {  // case 5
  const Scene scene = scene_of(kVersion + "plane { z, 0 pigment { checker rgb 1 } }");
  const auto& entries = std::get<ColorMap>(pigment_of(scene).map).entries;
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].value.rgb, Rgb(1, 1, 1));
  EXPECT_EQ(entries[1].value.rgb, Rgb(0, 1, 0));
}

TEST(Pigments, BareNumbersInListsAreAllFiveComponents) {
  const Scene scene = scene_of(kVersion + "plane { z, 0 pigment { checker 1, 0 } }");
  const auto& entries = std::get<ColorMap>(pigment_of(scene).map).entries;
  EXPECT_FLOAT_EQ(entries.at(0).value.transmit, 1);
}

TEST(Pigments, EmptyColorIsOpaqueBlack) {
  const Color color = plain_color(pigment_of(scene_of(kVersion + "sphere { 0, 1 pigment { color } }")));
  EXPECT_EQ(color, Color{});
}

TEST(Pigments, WarpsRunFromTheLastWrittenToClassicTurbulence) {
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 pigment { bozo turbulence 1 translate x warp { repeat x } scale 2 omega 0.6 } }");
  const WarpChain& chain = pigment_of(scene).body.warps;
  ASSERT_EQ(chain.size(), 4u);
  EXPECT_TRUE(std::holds_alternative<Transform>(chain[0]));
  EXPECT_TRUE(std::holds_alternative<RepeatWarp>(chain[1]));
  EXPECT_TRUE(std::holds_alternative<Transform>(chain[2]));
  EXPECT_FLOAT_EQ(std::get<ClassicTurbulence>(chain[3]).omega, 0.6f);
}

TEST(Pigments, MarbleAndWoodBringTheirWave) {
  EXPECT_EQ(pigment_of(scene_of(kVersion + "sphere { 0, 1 pigment { marble } }")).body.wave, Wave::kTriangle);
  EXPECT_EQ(pigment_of(scene_of(kVersion + "sphere { 0, 1 pigment { bozo } }")).body.wave, Wave::kRamp);
}

TEST(Pigments, WordsOfOtherPatternsAreErrors) {
  EXPECT_THAT(rejection_of(kVersion + "sphere { 0, 1 pigment { bozo agate_turb 2 } }"),
              testing::HasSubstr("Keyword 'agate_turb' cannot be used with non-agate."));
}

TEST(Pigments, ASecondPatternIsNotUnderstood) {
  EXPECT_THAT(rejection_of(kVersion + "sphere { 0, 1 pigment { bozo wood } }"), testing::HasSubstr("No matching } in 'pigment'"));
}

TEST(Pigments, AverageNeedsAMapAndItsWeightsMayBeLeftOut) {
  EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 pigment { average } }"), "Average must have map.");
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 pigment { average pigment_map { [bozo] [3 wood] } } }");
  const auto& entries = std::get<PigmentMap>(pigment_of(scene).map).entries;
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_FLOAT_EQ(entries[0].position, 1);
  EXPECT_FLOAT_EQ(entries[1].position, 3);
}

TEST(Normals, NeedAType) {
  EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 normal { scale 2 } }"), "No normal type given.");
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 normal { bumps 0.3 scale 2 } }");
  EXPECT_FLOAT_EQ(layer(only_object(scene), 0).normal->amount, 0.3f);
}

// Measured: POV-Ray complains of what an object has at its end, not of what is written on the way.
TEST(Normals, MayGetTheirTypeLater) {
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 normal { bump_size 1.5 } normal { bumps } }");
  EXPECT_FLOAT_EQ(layer(only_object(scene), 0).normal->amount, 1.5f);
  EXPECT_EQ(rejection_of(kVersion + "#declare Unused = texture { normal { bump_size 1.5 } } sphere { 0, 1 }"), "");
  const std::string untyped_default = kVersion + "#default { normal { bump_size 1.5 } }";
  EXPECT_EQ(rejection_of(untyped_default + "light_source { 0 rgb 1 } sphere { 0, 1 texture { normal { bumps } } }"), "");
  for (const char* object : {"sphere { 0, 1 }", "sphere { 0, 1 pigment { rgb 1 } }",
                             "union { plane { z, 0 } sphere { 0, 1 texture { normal { bumps } } } }",
                             "sphere { 0, 1 texture { normal { bumps } } interior_texture { pigment { rgb 1 } } }",
                             "blob { threshold .5 sphere { 0, 1, 1 texture { pigment { rgb 1 } } } texture { normal { bumps } } }",
                             "sphere { 0, 1 normal { gradient x normal_map { [0 bumps] [1 scale 2] } } }"})
    EXPECT_EQ(rejection_of(untyped_default + object), "No normal type given.") << object;
}

TEST(Finishes, AlbedoScalesWithTheValuesAtTheEndOfTheBlock) {  // chapter 11 §9.5
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 finish { diffuse albedo .25 brilliance 3 specular albedo .1 roughness .1 } }");
  EXPECT_FLOAT_EQ(finish_of(scene).diffuse, 0.5f);  // x (3 + 1) / 2
  EXPECT_FLOAT_EQ(finish_of(scene).raw_diffuse, 0.25f);
  EXPECT_NEAR(finish_of(scene).specular, 0.1 * 12 / (4 * (2 - std::pow(2.0, -5))), 1e-6);
}

TEST(Finishes, IdentifiersReplaceTheDefault) {
  const Scene scene = scene_of(kVersion + R"(#declare F = finish { phong 1 } #default { finish { ambient 0.7 } }
    sphere { 0, 1 finish { F } })");
  EXPECT_FLOAT_EQ(finish_of(scene).phong, 1);
  EXPECT_FLOAT_EQ(finish_of(scene).ambient.r, 0.1f);
}

TEST(Finishes, FresnelReflectionOfOneColorStartsFromZero) {
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 finish { reflection { 0.8 fresnel on } } }");
  EXPECT_EQ(finish_of(scene).reflection_min, Rgb(0.0f));
  EXPECT_EQ(finish_of(scene).reflection_max, Rgb(0.8f));
}

TEST(Textures, PatternedTexturesNeedAMap) {
  EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 texture { bozo } }"), "Patterned texture must have texture_map.");
  EXPECT_EQ(rejection_of(kVersion + "#default { texture { checker texture { } } }"), "Default texture cannot be material map or tiles.");
}

// As POV-Ray 3.7.0.10 has it; its texture_map errors come without a place.
TEST(Textures, AverageIsMissingItsMapByAnotherName) {
  for (const char* content : {"average", "average scale 2", "average pigment { rgb 1 }"})
    EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 texture { " + content + " } }"), "Average must have map.") << content;
}

// Measured with POV-Ray 3.7.0.10: whatever is missing of a list is the default texture, also all of it; a texture too many is not.
TEST(Textures, ListsAreFilledWithTheDefault) {
  for (const char* pattern : {"checker", "object { sphere { 0, 1 } }", "hexagon", "cubic scale 2"}) {
    const Scene scene = scene_of(kVersion + "#default { pigment { rgb x } } sphere { 0, 1 texture { " + pattern + " } }");
    const auto& list = std::get<PatternedTexture>(only_object(scene).texture.texture->content);
    ASSERT_GE(list.map.entries.size(), 2u) << pattern;
    for (const auto& entry : list.map.entries)
      EXPECT_EQ(plain_color(*std::get<std::vector<TextureLayer>>(entry.value->content).at(0).pigment).rgb, Rgb(1, 0, 0)) << pattern;
  }
  EXPECT_THAT(rejection_of(kVersion + "sphere { 0, 1 texture { checker texture { } texture { } texture { } } }"),
              testing::HasSubstr("No matching } in 'texture', texture found instead"));
  EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 texture { checker texture_map { [0 pigment { rgb 1 }] } } }"),
            "Keyword 'texture_map' cannot be used with this pattern type.");
}

// The words are POV-Ray 3.7.0.10's.
TEST(Maps, AreRefusedByPatternsThatCannotHaveThem) {
  const std::pair<const char*, const char*> cases[] = {
      {"pigment { checker pigment_map { [0 rgb 1] } }", "Keyword 'pigment_map' cannot be used with this pigment type."},
      {"pigment { rgb 1 pigment_map { [0 rgb 1] } }", "Keyword 'pigment_map' cannot be used with this pigment type."},
      {"pigment { average color_map { [0 rgb 1] } }", "Cannot use color_map with this pattern type."},
      {"normal { checker normal_map { [0 bumps] } }", "Keyword 'normal_map' cannot be used with this normal type."},
      {"normal { facets normal_map { [0 bumps] } }", "Keyword 'normal_map' cannot be used with this normal type."},
      {"normal { average normal_map { [1 bumps] } slope_map { [0 <0, 1>] } }", "Keyword 'slope_map' cannot be used with this normal type."},
      {"interior { media { density { checker density_map { [0 rgb 1] } } } }", "Keyword 'density_map' cannot be used with this density type."}};
  for (const auto& [content, message] : cases) EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 " + content + " }"), message) << content;
}

TEST(Textures, TilesAreACheckerWithTheSecondAtZero) {
  const Scene scene = scene_of(
      kVersion + "sphere { 0, 1 texture { tiles { texture { pigment { rgb x } } tile2 texture { pigment { rgb y } } } } }");
  const auto& tiles = std::get<PatternedTexture>(only_object(scene).texture.texture->content);
  const auto& at_zero = std::get<std::vector<TextureLayer>>(tiles.map.entries.at(0).value->content);
  EXPECT_EQ(plain_color(*at_zero.at(0).pigment).rgb, Rgb(0, 1, 0));
}

TEST(Textures, UpperLayersOfOldScenesDoNotFilter) {  // case 18
  const Scene scene = scene_of("#version 3.1; plane { z, 0 texture { pigment { rgb 1 } } texture { pigment { rgbf <1, 0, 0, 1> } } }");
  const Color top = plain_color(*layer(only_object(scene), 1).pigment);
  EXPECT_FLOAT_EQ(top.filter, 0);
  EXPECT_FLOAT_EQ(top.transmit, 1);
}

TEST(Maps, DensityMapIdentifiersCannotBeUsed) {
  EXPECT_EQ(rejection_of(kVersion + "#declare D = density_map { [0 rgb 0] [1 rgb 1] } media { density { bozo density_map { D } } }"),
            "Must have at least one entry in map.");
}

}  // namespace
}  // namespace lute::test
