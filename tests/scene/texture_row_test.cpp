// Textures from the text to a row of pixels: causes of differences from POV-Ray that no single part shows by itself. All numbers
// were measured with POV-Ray 3.7.0.10 (+W4 +H1 +FN16 File_Gamma=1): pixel centres x = -1.5, -0.5, 0.5, 1.5, y = 0.
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/build/geometry_answers.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/render/scene_view.hpp"
#include "engine/texture/texture_functions.hpp"
#include "parser/parse.hpp"

namespace lute {
namespace {

struct Row {
  std::string name;
  std::string text;
  std::array<Rgb, 4> expected;
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.text; }

constexpr float kTolerance = 6e-5f;  // the numbers have four digits
constexpr const char* kView = R"(#version 3.7;
global_settings { assumed_gamma 1 ambient_light 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
#default { finish { ambient 1 diffuse 0 } }
)";

class TextureRow : public testing::TestWithParam<Row> {};

TEST_P(TextureRow, HasTheColorsOfTheReference) {
  GeometryAnswers geometry;
  CompiledTextureFunctions functions(make_inside_test);
  ParseOptions options;
  options.input_file = "row.pov";
  options.input_text = kView + GetParam().text;
  options.width = 4;
  options.height = 1;
  options.geometry = &geometry;
  options.texture_functions = &functions;
  const ParseResult parsed = parse_scene(options);
  ASSERT_TRUE(parsed.ok) << (parsed.diagnostics.empty() ? std::string() : parsed.diagnostics.back().message);
  const RenderPlan plan = make_plan(parsed.scene);
  const auto built = build_scene(parsed.scene, plan);
  const Tracer tracer(*built, plan);
  const SceneView view(parsed.scene.camera, *built->textures, tracer, 4, 1);
  const auto source = view.make_source();
  for (std::size_t i = 0; i < 4; ++i) {
    const Rgb seen = source->sample({static_cast<double>(i), 0}).rgb;
    const Rgb expected = GetParam().expected[i];
    EXPECT_NEAR(seen.r, expected.r, kTolerance) << "pixel " << i;
    EXPECT_NEAR(seen.g, expected.g, kTolerance) << "pixel " << i;
    EXPECT_NEAR(seen.b, expected.b, kTolerance) << "pixel " << i;
  }
}

const std::string kFilm = "finish { ambient 0 diffuse .5 irid { 1 thickness .02 turbulence 2 } }";
const std::string kLamp = "light_source { -10*z rgb 1 parallel point_at 0 }";
const std::array<Rgb, 4> kFilmColors{Rgb(.4256f, .1611f, .0969f), Rgb(.8010f, .6601f, .6102f), Rgb(.9473f, .9060f, .8903f),
                                     Rgb(.7692f, .6099f, .5545f)};

const std::string kLit = "#default { finish { ambient 0 diffuse 1 } } plane { z, 0 ";
const std::string kRough = "pigment { rgb .2 } normal { granite .1 scale .4 }";

std::vector<Row> rows() {
  const Rgb cyan(0, 1, 1), black(0.0f);
  return {
      // What moved the object before its texture began does not move the default that the texture starts from.
      {"DefaultIsNotMoved", "#default { pigment { gradient x scale .4 } } box { -5, 5 scale .5 pigment { frequency 1 } }",
       {Rgb(.25f), Rgb(.75f), Rgb(.25f), Rgb(.75f)}},
      // A normal without type in the default is completed by the object's.
      {"UntypedDefaultNormal", "#default { pigment { aoi } normal { bump_size 1.5 } } plane { z, 0 normal { gradient x scallop_wave } }",
       {Rgb(.9964f), Rgb(.9964f), Rgb(.9964f), Rgb(.9964f)}},
      // The film's thickness is disturbed in the world's space, whatever moves or maps the texture.
      {"FilmOfMovedObject", kLamp + "plane { z, 0 pigment { rgb 1 } " + kFilm + " translate x }", kFilmColors},
      {"FilmOfMappedObject", kLamp + "box { <-3, -3, 0>, 3 uv_mapping pigment { rgb 1 } " + kFilm + " }", kFilmColors},
      // Chapter 50 §16 C7: slope sees the normal that the layer's own normal has made.
      {"SlopeSeesThePerturbedNormal", "plane { z, 0 pigment { slope { -z, 0, 1 } } normal { bumps .5 } }",
       {Rgb(.96452f), Rgb(.95270f), Rgb(.96043f), Rgb(.94115f)}},
      // A texture with a pattern and without bump scale is lit by a normal as long as its transformation has made it: scale .5, twice as
      // bright. Without bump scale on the layer or its normal alone it is a unit.
      {"LitByTheLengthWithoutBumpScale", kLamp + kLit + "texture { gradient x texture_map { [0 " + kRough + "] } no_bump_scale scale .5 } }",
       {Rgb(.3921f), Rgb(.3949f), Rgb(.3982f), Rgb(.3844f)}},
      {"LitByAUnitWithBumpScale", kLamp + kLit + "texture { gradient x texture_map { [0 " + kRough + "] } scale .5 } }",
       {Rgb(.1999f), Rgb(.1999f), Rgb(.2000f), Rgb(.1995f)}},
      {"LitByAUnitWithoutBumpScaleOfTheNormal",
       kLamp + kLit + "texture { gradient x texture_map { [0 pigment { rgb .2 } normal { granite .1 no_bump_scale scale .4 }] } scale .5 } }",
       {Rgb(.1993f), Rgb(.1994f), Rgb(.1998f), Rgb(.1975f)}},
      {"LitByAUnitWithoutBumpScaleOfALayer", kLamp + kLit + "pigment { rgb .5 } normal { granite .2 no_bump_scale scale .5 } }",
       {Rgb(.4902f), Rgb(.4971f), Rgb(.4959f), Rgb(.4908f)}},
      // Our own: the square of such a length is 0, and POV-Ray's picture black.
      {"GradientOfTheTiniestDirection", "plane { z, 0 pigment { gradient <1e-200, 0, 0> scale 4 translate -2*x } }",
       {Rgb(.125f), Rgb(.375f), Rgb(.625f), Rgb(.875f)}},
      // A normal over u and v bends the normal as the world has it, however its object was turned.
      {"MappedNormalOfATurnedObject",
       kLamp + "#default { finish { ambient 0 diffuse 1 } } box { -4, 4 pigment { rgb .5 } normal { uv_mapping bumps .6 scale .1 } rotate 20*x }",
       {Rgb(.4757f), Rgb(.4659f), Rgb(.4491f), Rgb(.4396f)}},
      // A plain colour covers a map, which comes back with the next pattern.
      {"MapUnderAPlainColor", "#default { pigment { gradient x color_map { [0 rgb x] [1 rgb z] } } } #default { pigment { rgb y } } "
                              "plane { z, 0 pigment { bozo scale .2 } }",
       {Rgb(.4414f, 0, .5586f), Rgb(.3822f, 0, .6178f), Rgb(.4874f, 0, .5126f), Rgb(.3361f, 0, .6639f)}},
      {"ListUnderAPlainColor", "#declare P = pigment { checker } #declare Q = pigment { P rgb y } plane { z, 0 pigment { Q bozo scale .2 } }",
       {Rgb(0, .5586f, .4414f), Rgb(0, .6178f, .3822f), Rgb(0, .5126f, .4874f), Rgb(0, .6639f, .3361f)}},
      {"MandelColors", "plane { z, 0 pigment { mandel 20 } }", {cyan, cyan, cyan, black}},
      {"MandelOfOtherExponentIsGrey", "plane { z, 0 pigment { mandel 20 exponent 3 } }", {black, Rgb(.2f), Rgb(.2f), black}},
  };
}

INSTANTIATE_TEST_SUITE_P(All, TextureRow, testing::ValuesIn(rows()), [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace lute
