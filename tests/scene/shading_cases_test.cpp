// The check cases of specification chapter 40 §19 as scene text: from the text to the colour of a pixel. All numbers were measured
// with POV-Ray 3.7.0.10, 16 bits, linear. Cases whose random numbers are POV-Ray's own stream (5, 15b jitter) are not repeated here.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/build/geometry_answers.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/render/scene_view.hpp"
#include "parser/parse.hpp"

namespace lute {
namespace {

struct Case {
  std::string name;
  std::string text;
  float r, g, b;
  int quality = 9;
  bool alpha = false;
  float coverage = 1;  // with alpha: the colours are those divided by it
};

// The shorthand of §19, as macros and declarations of the scene language.
const char* const kShorthand = R"(
global_settings { assumed_gamma 1 }
#macro CAM(A) camera { orthographic location <0, 5*tan(radians(A)), -5> direction <0, -tan(radians(A)), 1> right x*0.01 up y*0.01 } #end
#macro SUN() light_source { <0,0,-100>, rgb 1 } #end
#macro BG() background { rgb <.2,.4,.8> } #end
#macro SLAB() camera { orthographic location 0 direction z right x*0.01 up y*0.01 }
  box { <-9,-9,5>, <9,9,6> pigment { rgb 1 } finish { ambient 1 diffuse 0 } } #end
#declare A0 = finish { ambient 0 diffuse 1 }
#declare None = finish { ambient 0 diffuse 0 }
)";

Color seen(const Case& c) {
  GeometryAnswers geometry;
  ParseOptions parse;
  parse.input_file = c.name;
  const bool own_version = c.text.starts_with("#version");
  parse.input_text = (own_version ? "" : "#version 3.7;\n") + c.text.substr(0, own_version ? c.text.find('\n') + 1 : 0) + kShorthand +
                     c.text.substr(own_version ? c.text.find('\n') + 1 : 0);
  parse.width = parse.height = 1;
  parse.geometry = &geometry;
  std::string messages;
  parse.on_diagnostic = [&](const Diagnostic& d) { messages += d.message + "\n"; };
  const ParseResult parsed = parse_scene(parse);
  EXPECT_TRUE(parsed.ok) << messages;
  if (!parsed.ok) return {};
  BuildOptions options;
  options.quality = c.quality;
  options.output_alpha = c.alpha;
  const RenderPlan plan = make_plan(parsed.scene, options);
  const auto built = build_scene(parsed.scene, plan);
  const Tracer tracer(*built, plan);
  const SceneView view(parsed.scene.camera, *built->textures, tracer, 1, 1);
  return view.make_source()->sample({0, 0});
}

std::vector<Case> finish_cases() {
  const std::string oblique = "CAM(0) light_source{<0,1,-1>*1000, rgb 1} plane{-z,0 pigment{rgb <1,.5,.25>} finish{";
  return {
      {"1", oblique + "ambient 0 diffuse .8}}", .56568f, .28284f, .14142f},
      {"1Brilliance", oblique + "ambient 0 diffuse .8 brilliance 3}}", .28284f, .14142f, .07071f},
      {"1Albedo", oblique + "diffuse albedo .8 brilliance 3 ambient 0}}", .56568f, .28284f, .14142f},
      {"1bPhong", oblique + "ambient 0 diffuse 0 phong .5 phong_size 3}}", .17678f, .17678f, .17678f},
      {"1bSpecular", oblique + "ambient 0 diffuse 0 specular .5 roughness .1}}", .22654f, .22654f, .22654f},
      {"1bMetallic", oblique + "ambient 0 diffuse 0 specular .5 roughness .1 metallic}}", .22654f, .11624f, .06110f},
      {"1bSpecularAlbedo", oblique + "ambient 0 diffuse 0 specular albedo .1 roughness .1}}", .06903f, .06903f, .06903f},
      {"2", "CAM(0) light_source{<0,sin(radians(75)),-cos(radians(75))>*1000, rgb 1} plane{-z,0 pigment{rgb <1,.5,.25>} "
            "finish{ambient 0 diffuse 0 specular .5 roughness 1 metallic}}", .39667f, .23119f, .14846f},
      {"3", "CAM(0) SUN() background{rgb <.2,.3,.4>} plane{-z,0 pigment{rgbft <1,.5,.25,.5,.2>} finish{ambient .1 diffuse .8}}", .41f,
       .27f, .1975f},
      {"3b", "CAM(0) SUN() plane{-z,0 pigment{rgbft <.8,.5,.25,.5,.2>} finish{ambient .1 diffuse .8}}", .216f, .135f, .0675f},
      {"3bLegacy", "#version 3.6;\nCAM(0) SUN() plane{-z,0 pigment{rgbft <.8,.5,.25,.5,.2>} finish{ambient .1 diffuse .8}}", .288f, .18f,
       .09f},
      {"4", "CAM(0) SUN() plane{-z,0 texture{pigment{rgb <1,1,0>} finish{ambient 0 diffuse .8}} "
            "texture{pigment{rgbft <1,.5,.25,.5,.2>} finish{ambient 0 diffuse .6}}}", .74f, .45f, .045f},
      {"6", "CAM(0) SUN() plane{-z,0 pigment{rgb 1} finish{ambient 0 diffuse .5 irid{.4 thickness .1}}}", .4555f, .3503f, .3268f},
      {"32", "CAM(0) SUN() BG() plane{-z,0 texture{pigment{rgb 1} finish{ambient 0 diffuse 0 reflection .5}} "
             "texture{pigment{rgb 0} finish{None}}}", 0, 0, 0},
      {"33", "CAM(0) light_source{<0,0,-1>*1000, rgb 1} plane{-z,0 texture{pigment{rgb 0} finish{ambient 0 diffuse 0 phong .5}} "
             "texture{pigment{rgbf <1,.5,.25,.5>} finish{None}}}", .25f, .125f, .0625f},
  };
}

std::vector<Case> mirror_and_glass_cases() {
  const std::string black = " BG() plane{-z,0 pigment{rgb 0} finish{ambient 0 diffuse 0 ";
  const std::string glass_stack =
      "CAM(0) BG() #for(I,0,N) plane{-z,-I pigment{rgbt 1} finish{None} interior{ior 1.1+Step*I}} #end";
  const std::string fade_box = "CAM(0) BG() box{-1,1 pigment{rgbt 1} finish{None} interior{fade_distance 1 fade_color <1,.5,0> ";
  const std::string prism =
      "camera{orthographic location <0,0,-5> direction z right x*.001 up y*.001} "
      "sky_sphere{pigment{gradient y color_map{[0 rgb 0][1 rgb 1]} scale 2 translate -y}} "
      "plane{<0,1,-1>,0 pigment{rgbt 1} finish{None} interior{ior 1.5 ";
  const std::string facing = "CAM(0) plane{z,0 pigment{rgb 1} finish{ambient .1 diffuse 0 reflection 1}} "
                             "plane{-z,6 pigment{rgb 1} finish{ambient .01 diffuse 0 reflection 1}}";
  return {
      {"7", "CAM(60)" + black + "reflection{0,1}}}", .1f, .2f, .4f},
      {"7Falloff", "CAM(60)" + black + "reflection{.1,1 falloff 2}}}", .065f, .13f, .26f},
      {"7Fresnel", "CAM(60)" + black + "reflection{1 fresnel}} interior{ior 1.5}}", .01784f, .03568f, .07135f},
      {"7FresnelRange", "CAM(60)" + black + "reflection{.1,.8 fresnel}} interior{ior 1.5}}", .03249f, .06497f, .12995f},
      {"8", "CAM(0)" + black + "reflection{1 exponent 2}}}", .44721f, .63246f, .89442f},
      {"9", "CAM(75) BG() plane{-z,0 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse 0 reflection{1 metallic}}}", .2f, .23313f, .2994f},
      {"9Back", "CAM(75) BG() plane{z,0 pigment{rgb <1,.5,.25>} finish{ambient 0 diffuse 0 reflection{1 metallic}}}", .2f, .23313f,
       .2994f},
      {"10", "CAM(0) BG() plane{-z,0 pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection .25}}", .25f, .5f, 1},
      {"10Conserving", "CAM(0) BG() plane{-z,0 pigment{rgbt 1} finish{ambient 0 diffuse 0 reflection .25 conserve_energy}}", .2f, .4f, .8f},
      {"11Five", "global_settings{max_trace_level 5}" + facing, .32f, .32f, .32f},
      {"11Two", "global_settings{max_trace_level 2}" + facing, .11f, .11f, .11f},
      {"12Four", "#declare N=3; #declare Step=.1;" + glass_stack, .2f, .4f, .8f},
      {"12Five", "#declare N=4; #declare Step=.1;" + glass_stack, 0, 0, 0},
      {"12Same", "#declare N=4; #declare Step=0;" + glass_stack, .2f, .4f, .8f},
      {"17Two", fade_box + "fade_power 2}}", .2f, .24f, .16f},
      {"17Zero", fade_box + "}}", .2f, .3f, .4f},
      {"17Many", fade_box + "fade_power 1001}}", .2f, .14716f, .10826f},
      {"18", "CAM(0) BG() box{-1,1 pigment{rgbt 1} finish{None} interior{ior 1.5 dispersion 1.1}}", .19876f, .4f, .79696f},
      {"18bNone", prism + "}}", .35486f, .35486f, .35486f},
      {"18bSeven", prism + "dispersion 1.2}}", .36498f, .3588f, .34279f},
      {"18bTwo", prism + "dispersion 1.2 dispersion_samples 2}}", .36371f, .36056f, .34257f},
      {"18bTwenty", prism + "dispersion 1.2 dispersion_samples 20}}", .365f, .3588f, .34275f},
      {"28", "global_settings{max_trace_level 20} BG() camera{location <0,.3,-5> direction z right x*.001 up y*.001} "
             "union{sphere{0,1} sphere{z*1.2,1} pigment{rgbt 1} finish{None} interior{ior 1.5 fade_distance 1 fade_power 2}}",
       .03439f, .06877f, .13754f},
  };
}

std::vector<Case> light_cone_cases() {
  std::vector<Case> cases;
  const auto spot = [&](const std::string& name, const std::string& degrees, const std::string& items, float v) {
    cases.push_back({name, "#declare X = 10*tan(radians(" + degrees + ")); camera{orthographic location <X,0,-5> direction z right x*.0001 "
                           "up y*.0001} light_source{<0,0,-10>, rgb 1 spotlight " + items + " point_at 0} "
                           "plane{-z,0 pigment{rgb 1} finish{ambient 0 diffuse 1 brilliance 0}}", v, v, v});
  };
  spot("13At29", "29", "", 1);
  spot("13At35", "35", "", .79033f);
  spot("13At40", "40", "", .31061f);
  spot("13At44", "44", "", .01686f);
  spot("13At46", "46", "", 0);
  spot("13Tight", "20", "radius 0 falloff 45 tightness 10", .47794f);
  const auto cylinder = [&](const std::string& name, const std::string& x, float v) {
    cases.push_back({name, "camera{orthographic location <" + x + ",0,-5> direction z right x*.0001 up y*.0001} light_source{<0,0,-10>, "
                           "rgb 1 cylinder point_at 0} plane{-z,0 pigment{rgb 1} finish{A0}}", v, v, v});
  };
  cylinder("13Inner", ".7", 1);
  cylinder("13Edge", ".8", .896f);
  cylinder("13Outer", ".9", .352f);
  cases.push_back({"30", "camera{orthographic location <3,0,-5> direction z right x*.01 up y*.01} light_source{<0,0,-10>, rgb 1 spotlight "
                         "parallel radius 10 falloff 20 point_at 0} plane{-z,0 pigment{rgb 1} finish{A0}}", 1, 1, 1});
  return cases;
}

std::vector<Case> area_light_cases() {
  std::vector<Case> cases;
  const auto area = [&](const std::string& name, const std::string& grid, const std::string& edge, float v) {
    cases.push_back({name, "CAM(0) light_source{<0,0,-100>, rgb 1 area_light x*20,y*20," + grid + "} box{<-100,-100,-6>,<" + edge +
                           ",100,-5> pigment{rgb 0} no_image} plane{-z,0 pigment{rgb 1} finish{A0}}", v, v, v});
  };
  area("15Three", "3,3", "-.05", .75f);
  area("15FiveA", "5,1", "-.35", .875f);
  area("15FiveB", "5,1", "-.1", .625f);
  area("15FiveC", "5,1", ".1", .375f);
  area("15Four", "4,4", ".25", .25f);
  area("15Adaptive", "5,5 adaptive 0", "-.35", .875f);
  area("15Circular", "5,5 circular", ".4", .09375f);
  area("15Seventeen", "17,1 adaptive 1", ".3", .21875f);
  cases.push_back({"15bIllumination", "CAM(0) light_source{<0,0,-100>, rgb 1 area_light x*200,y*200,3,3 area_illumination} "
                                      "plane{-z,0 pigment{rgb 1} finish{A0}}", .68199f, .68199f, .68199f});
  return cases;
}

std::vector<Case> shadow_cases() {
  std::vector<Case> cases;
  const auto shadow = [&](const std::string& name, const std::string& object, float r, float g, float b) {
    cases.push_back({name, "CAM(0) SUN() " + object + " plane{-z,0 pigment{rgb 1} finish{A0}}", r, g, b});
  };
  shadow("16Plane", "plane{z,-1 pigment{rgbft <1,.5,.25,.5,.2>} no_image}", .7f, .45f, .325f);
  shadow("16Sphere", "sphere{-3*z,1 pigment{rgbft <1,.5,.25,.5,.2>} no_image}", .49f, .2025f, .10562f);
  shadow("16Fade", "sphere{-3*z,1 pigment{rgbt 1} no_image interior{fade_distance 1 fade_power 2 fade_color <1,.5,0>}}", 1, .6f, .2f);
  shadow("16FadeMuch", "sphere{-3*z,1 pigment{rgbt 1} no_image interior{fade_distance 1 fade_power 1000 fade_color <1,.5,0>}}", 1, .36788f,
         .13533f);
  const auto no_shadow = [&](const std::string& name, const std::string& kind, const std::string& items, float v) {
    shadow(name, kind + "{sphere{-3*z,1 no_shadow} sphere{<9,9,-3>,1} pigment{rgb 1} no_image " + items + "}", v, v, v);
  };
  no_shadow("25Union", "union", "", 1);
  no_shadow("25Whole", "union", "split_union off", 0);
  no_shadow("25Merge", "merge", "", 0);
  shadow("26", "light_source{<0,0,100>, rgb 0}", 1, 1, 1);
  cases.push_back({"34", "CAM(0) light_source{<0,0,-100>, rgb .1} sphere{-3*z,1 pigment{rgbf <1,1,1,.5>} finish{caustics .1} no_image} "
                         "plane{-z,0 pigment{rgb 1} finish{A0}}", .1f, .1f, .1f});
  return cases;
}

std::vector<Case> light_position_cases() {
  std::vector<Case> cases;
  cases.push_back({"14", "CAM(0) light_source{<0,0,-100>, rgb 1 fade_distance 50 fade_power 2} plane{-z,0 pigment{rgb 1} finish{A0}}", .4f,
                   .4f, .4f});
  cases.push_back({"26Behind", "CAM(0) light_source{<0,0,100>, rgb 1} plane{-z,0 pigment{rgb 1} finish{A0} no_shadow}", 0, 0, 0});
  cases.push_back({"26Double", "CAM(0) light_source{<0,0,100>, rgb 1} plane{-z,0 pigment{rgb 1} finish{A0} double_illuminate}", 1, 1, 1});
  cases.push_back({"26Back", "CAM(0) light_source{<0,0,100>, rgb 1} plane{-z,0 pigment{rgb 1} finish{ambient 0 diffuse .3,.4 brilliance 1}}",
                   .4f, .4f, .4f});
  const std::string parallel = "CAM(0) box{<-9,-9,-9>,<9,9,-8> pigment{rgb 1} no_image} plane{-z,0 pigment{rgb 1} finish{A0}} "
                               "light_source{<0,0,10>, rgb 1 parallel point_at <0,0,20> ";
  cases.push_back({"29", parallel + "}", 1, 1, 1});
  cases.push_back({"29Fade", parallel + "fade_distance 5 fade_power 2}", .4f, .4f, .4f});
  return cases;
}

std::vector<Case> surroundings_cases() {
  const std::string sky = "CAM(0) background{rgb <.1,.2,.3>} sky_sphere{pigment{rgbft <1,0,0,.2,.3>} pigment{rgbft <.5,1,0,.3,.5>}}";
  const std::string ground = "fog{fog_type 2 distance 1 fog_alt .5 fog_offset .5 rgb <0,.5,1>} ";
  const std::string lamp = "camera{orthographic location 0 direction z right x*.01 up y*.01} box{<-9,-9,5>,<9,9,6> pigment{rgb 1} "
                           "finish{ambient 0 diffuse 1}} fog{distance 10 rgb 0} light_source{0, rgb 1 ";
  const std::string bow = "#ifndef(Turn) #declare Turn = 0; #end camera{direction vrotate(vrotate(z,-30*x),Turn*z) right x*.0001 up "
                          "y*.0001} sphere{0,50 hollow pigment{rgb <.1,.2,.3>} finish{ambient 1 diffuse 0}} "
                          "rainbow{angle 30 width 20 distance 100 direction z up y "
                          "color_map{[0 rgbft <1,.5,.25,.3,.2>][1 rgbft <1,.5,.25,.3,.2>]} ";
  const std::string clear = "CAM(0) background{rgbft <.4,.8,.4,.3,.5>} plane{-z,0 pigment{rgbft <1,.5,.25,.5,.2>} finish{ambient 1 diffuse "
                            "0}}";
  const std::string part = "{sphere{0,1 no_image} ";
  const std::string glow = " pigment{rgb 1} finish{ambient 1 diffuse 0}}";
  return {
      {"19", sky, .4575f, .248f, .045f},
      {"19Legacy", "#version 3.6;\n" + sky, .518f, .23f, .045f},
      {"20", "SLAB() fog{distance 10 rgb <.5,.25,0>}", .80327f, .70489f, .60653f},
      {"20Filter", "SLAB() fog{distance 10 rgbft <.5,.25,0,.5,.1>}", .65164f, .47745f, .30326f},
      {"20Transmit", "SLAB() fog{distance 10 rgbft <.5,.25,0,0,.7>}", .85f, .775f, .7f},
      {"20Two", "SLAB() fog{distance 10 rgb <1,0,0>} fog{distance 20 rgb <0,1,0>}", .86584f, .69357f, .47237f},
      {"21Up", ground + "camera{orthographic location 0 direction y right x*.01 up z*.01} box{<-9,2,-9>,<9,3,9>" + glow, .3248f, .66241f, 1},
      {"21Along", ground + "camera{orthographic location y direction z right x*.01 up y*.01} box{<-9,-9,2>,<9,9,3>" + glow, .36788f,
       .68394f, 1},
      {"22", lamp + "}", .60653f, .60653f, .60653f},
      {"22Attenuation", lamp + "media_attenuation on}", .36788f, .36788f, .36788f},
      {"22NoInteraction", lamp + "media_attenuation on media_interaction off}", .60653f, .60653f, .60653f},
      {"23", bow + "}", .45412f, .31089f, .26423f},
      {"23Arc", "#declare Turn = 75;" + bow + "arc_angle 160 falloff_angle 80}", .13094f, .20932f, .29604f},
      {"24Union", "CAM(0) BG() union" + part + "sphere{9,1}" + glow, .2f, .4f, .8f},
      {"24Whole", "CAM(0) BG() union" + part + "sphere{9,1} split_union off" + glow, 1, 1, 1},
      {"24Merge", "CAM(0) BG() merge" + part + "sphere{9,1}" + glow, .2f, .4f, .8f},
      {"24Intersection", "CAM(0) BG() intersection" + part + "sphere{0,2}" + glow, 1, 1, 1},
      {"27One", "CAM(0) SUN() plane{-z,0 pigment{rgb <1,.5,.25>} finish{ambient .1 diffuse .5}}", 1, .5f, .25f, 1},
      {"27Three", "CAM(0) SUN() box{<-9,-9,-9>,<9,9,-8> pigment{rgb 1} no_image} plane{-z,0 pigment{rgb <1,.5,.25>} finish{ambient .1 "
                  "diffuse .5}}", .6f, .3f, .15f, 3},
      {"27Four", "CAM(0) SUN() box{<-9,-9,-9>,<9,9,-8> pigment{rgb 1} no_image} plane{-z,0 pigment{rgb <1,.5,.25>} finish{ambient .1 "
                 "diffuse .5}}", .1f, .05f, .025f, 4},
      {"27Five", "CAM(0) SUN() plane{-z,0 pigment{rgb <1,.5,.25> quick_color <0,1,0>} finish{ambient .1 diffuse .5}}", 0, .6f, 0, 5},
      {"31", clear, .5496f, .34272f, .15592f, 9, true, .64776f},
      {"31Legacy", "#version 3.6;\n" + clear, .61224f, .30613f, .15306f, 9, true, .49f},
  };
}

class ShadingCase : public ::testing::TestWithParam<Case> {};

TEST_P(ShadingCase, HasTheMeasuredColor) {
  const Case& c = GetParam();
  const Color color = seen(c);
  constexpr double kTolerance = 4e-5;
  EXPECT_NEAR(color.rgb.r, c.r * c.coverage, kTolerance);
  EXPECT_NEAR(color.rgb.g, c.g * c.coverage, kTolerance);
  EXPECT_NEAR(color.rgb.b, c.b * c.coverage, kTolerance);
  if (c.alpha) {
    EXPECT_NEAR(1 - color.transmit, c.coverage, kTolerance);
  }
}

const auto kName = [](const ::testing::TestParamInfo<Case>& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Finish, ShadingCase, ::testing::ValuesIn(finish_cases()), kName);
INSTANTIATE_TEST_SUITE_P(MirrorAndGlass, ShadingCase, ::testing::ValuesIn(mirror_and_glass_cases()), kName);
INSTANTIATE_TEST_SUITE_P(LightCone, ShadingCase, ::testing::ValuesIn(light_cone_cases()), kName);
INSTANTIATE_TEST_SUITE_P(AreaLight, ShadingCase, ::testing::ValuesIn(area_light_cases()), kName);
INSTANTIATE_TEST_SUITE_P(Shadow, ShadingCase, ::testing::ValuesIn(shadow_cases()), kName);
INSTANTIATE_TEST_SUITE_P(LightPosition, ShadingCase, ::testing::ValuesIn(light_position_cases()), kName);
INSTANTIATE_TEST_SUITE_P(Surroundings, ShadingCase, ::testing::ValuesIn(surroundings_cases()), kName);

}  // namespace
}  // namespace lute
