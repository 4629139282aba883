// The check cases of specification chapter 11 §16, and cases 16 and 17 of chapter 10 §14, from the text to the numbers in the file: 8-bit
// codes with the default output gamma, measured with POV-Ray 3.7.0.10. Errors (case 27) are in tests/parser/diagnostic; media (case
// 21) are not rendered yet.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "engine/build/geometry_answers.hpp"
#include "engine/output/encode.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/render/scene_view.hpp"
#include "engine/texture/texture_functions.hpp"
#include "parser/parse.hpp"

namespace lute {
namespace {

struct Case {
  std::string name;
  std::string text;
  int width, height;
  std::vector<int> codes;  // r, g, b of each pixel, rows from the top; or one number a pixel where all are grey
};

std::string head(const std::string& camera = "camera{orthographic location <0,0,-5> look_at 0 right 4*x up 3*y}") {
  return "#version 3.7;  global_settings{assumed_gamma 1}\n" + camera + "\n#default{finish{ambient 0 emission 1 diffuse 0}}\n";
}

std::vector<int> rendered(const Case& c) {
  GeometryAnswers geometry;
  CompiledTextureFunctions functions(make_inside_test);
  ParseOptions parse;
  parse.input_file = c.name;
  parse.input_text = c.text;
  parse.width = c.width;
  parse.height = c.height;
  parse.geometry = &geometry;
  parse.texture_functions = &functions;
  std::string messages;
  parse.on_diagnostic = [&](const Diagnostic& d) { messages += d.message + "\n"; };
  const ParseResult parsed = parse_scene(parse);
  EXPECT_TRUE(parsed.ok) << messages;
  if (!parsed.ok) return {};
  const RenderPlan plan = make_plan(parsed.scene);
  const auto built = build_scene(parsed.scene, plan);
  const Tracer tracer(*built, plan);
  const SceneView view(parsed.scene.camera, *built->textures, tracer, c.width, c.height);
  const auto source = view.make_source();
  Film film(c.width, c.height);
  for (int y = 0; y < c.height; ++y) {
    for (int x = 0; x < c.width; ++x) film.at(x, y) = source->sample({static_cast<double>(x), static_cast<double>(y)});
  }
  OutputSettings output;
  const Transfer transfer({parsed.scene.settings.gamma_mode, parsed.scene.settings.assumed_gamma}, output.file_gamma,
                          output.display_gamma);
  const EncodedImage image = encode(film, transfer, output);
  std::vector<int> codes(image.codes.begin(), image.codes.end());
  if (c.codes.size() * 3 != codes.size()) return codes;
  std::vector<int> grey;
  for (std::size_t i = 0; i < codes.size(); i += 3) {
    EXPECT_TRUE(codes[i] == codes[i + 1] && codes[i] == codes[i + 2]) << "pixel " << i / 3 << " is not grey";
    grey.push_back(codes[i]);
  }
  return grey;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const std::string kB = "box{<-2,-2,0>,<2,2,1> ";

std::vector<Case> texture_cases() {
  const std::string h = head();
  const std::string layers = "plane{z,0 texture{pigment{rgb 1}} texture{pigment{rgbf<1,0,0,1>}}}";
  std::vector<int> checker;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const bool green = (row + column) % 2 == 0;
      checker.insert(checker.end(), {green ? 0 : 255, 255, green ? 0 : 255});
    }
  }
  return {
      {"1", h + "plane{z,0 texture{pigment{rgb x}} texture{pigment{rgbt<0,1,0,.5>}} pigment{rgbt<0,0,1,.5>}}", 1, 1, {188, 0, 188}},
      {"2", h + "#declare T=texture{pigment{gradient x scale 4}} texture{pigment{rgbt<0,1,0,.5>}}" + kB + "texture{T translate x}}", 4, 1,
       {120, 216, 120, 152, 233, 152, 177, 248, 177, 71, 198, 71}},
      {"3", h + "#default{pigment{gradient x scale 4}} plane{z,0 pigment{color_map{[0 rgb x][1 rgb z]}}}", 4, 1,
       {165, 0, 207, 99, 0, 240, 240, 0, 99, 207, 0, 165}},
      {"4", h + "plane{z,0 pigment{gradient x scale 4 color_map{[0.0 0.5 color rgb x color rgb y][0.5 1.0 color rgb z color rgb 1]}}}", 4,
       1, {137, 137, 255, 225, 225, 255, 225, 137, 0, 137, 225, 0}},
      {"5", h + "plane{z,0 pigment{checker rgb 1}}", 4, 3, checker},
      {"6Before", h + "union{box{<-2,-1.5,-1>,<2,1.5,1>} translate x pigment{gradient x scale 4}}", 4, 1, {0, 240, 99, 165}},
      {"6Behind", h + "union{box{<-2,-1.5,-1>,<2,1.5,1>} pigment{gradient x scale 4} translate x}", 4, 1, {0, 207, 240, 99}},
      {"7", h + "union{box{<-2,-1.5,-1>,<2,1.5,1> pigment{gradient x scale 4 translate -2*x}} uv_mapping pigment{rgb 1}}", 4, 1,
       {224, 221, 219, 217}},
      {"7Without", h + "union{box{<-2,-1.5,-1>,<2,1.5,1> pigment{gradient x scale 4 translate -2*x}} pigment{rgb 1}}", 4, 1,
       {99, 165, 207, 240}},
      {"11", h + kB + "pigment{gradient x scale 4} material{translate x}}", 4, 1, {165, 207, 240, 99}},
      {"18Old", "#version 3.1;  global_settings{assumed_gamma 1}\n" + h.substr(h.find('\n') + 1) + layers, 1, 1, {255, 255, 255}},
      {"18New", h + layers, 1, 1, {255, 0, 0}},
      {"24", h + kB + "pigment{object{box{<-9,-9,-9>,<0,9,9>} translate x rgb x, rgb y}}}", 4, 1,
       {0, 255, 0, 0, 255, 0, 0, 255, 0, 255, 0, 0}},
      {"28", h + "mesh2{vertex_vectors{3,<-2,-2,0>,<2,-2,0>,<0,9,0>} texture_list{3,texture{pigment{rgb x}},texture{pigment{rgb y}},"
                 "texture{pigment{rgb z}}} face_indices{1,<0,1,2>,0,1,2}}", 4, 1,
       {229, 52, 118, 193, 145, 118, 145, 193, 118, 52, 229, 118}},
  };
}

std::vector<Case> object_cases() {
  const std::string h = head();
  const std::string cut = "#default{pigment{rgb y}} difference{box{<-2,-1.5,-1>,<2,1.5,1> pigment{rgb x}} box{<0,-2,-2>,<3,2,.5>}";
  const std::string no_default = h.substr(0, h.find("#default"));
  return {
      {"8", h + cut + "}", 4, 1, {255, 0, 0, 255, 0, 0, 0, 255, 0, 0, 255, 0}},
      {"8Cutaway", h + cut + " cutaway_textures}", 4, 1, {255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0}},
      {"9", h + "union{ box{<-2,-2,0>,<0,2,1> finish{emission .5}} box{<0,-2,0>,<2,2,1>} pigment{rgb x} }", 4, 1,
       {0, 0, 0, 0, 0, 0, 255, 0, 0, 255, 0, 0}},
      {"10", h + "#declare S=" + kB + "} #default{pigment{rgb y}} object{S}", 1, 1, {0, 255, 0}},
      {"12", h + "box{<-1,-2,0>,<1,2,1> pigment{rgb x} transform{translate x scale 2 inverse}}", 4, 1,
       {255, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0, 0}},
      {"22", h + kB + "pigment{rgb 1} finish{emission 0 brilliance 3 diffuse albedo .25}} light_source{-100*z 1}", 1, 1, {188}},
      {"23Ambient", no_default + kB + "pigment{rgb 1}}", 1, 1, {89}},
      {"23Lit", no_default + "light_source{<0,0,-100>,1} " + kB + "pigment{rgb 1} finish{ambient 0}}", 1, 1, {203}},
  };
}

std::vector<Case> camera_and_light_cases() {
  const auto stripes = [](const std::string& camera, char axis = 'x') {
    const std::string a(1, axis);
    return head(camera) + "plane{" + (axis == 'x' ? "z" : "x") + ",0 pigment{gradient " + a + " scale 8 translate -4*" + a + "}}";
  };
  const auto rows = [](std::vector<int> row) {
    std::vector<int> all;
    for (int i = 0; i < 3; ++i) all.insert(all.end(), row.begin(), row.end());
    return all;
  };
  const auto old = [](const std::string& items) {
    return "#version 3.1; global_settings{assumed_gamma 1} camera{" + items + "} #default{finish{ambient 1 diffuse 0}} "
           "plane{z,0 pigment{gradient x scale 8 translate -4*x}}";
  };
  const std::string h = head();
  const std::string group = h + "light_source{-10*z rgb x} light_group{light_source{-10*z rgb y} plane{z,0 pigment{rgb 1} "
                                "finish{diffuse 1 emission 0}} ";
  // Nested groups, red inside of green inside of blue; all numbers from POV-Ray.
  const std::string wall = "plane{z,0 pigment{rgb 1} finish{diffuse 1 emission 0}} ";
  const auto lit = [](const std::string& axis) { return "light_source{-10*z rgb " + axis + "} "; };
  const std::string inner = "light_group{" + lit("x") + wall;
  const std::string named = h + "#declare G=" + inner + "} ";
  const std::string plain = "camera{location -5*z right 2*x up 1.5*y look_at 0} plane{z,0 pigment{rgb .5} finish{ambient 1 diffuse 0}}";
  return {
      {"13", stripes("camera{location <0,0,-5> angle 90 right x*2 up y*1.5 look_at 0}"), 4, 3, rows({49, 158, 212, 251})},
      {"13Turned", stripes("camera{look_at 0 up y*1.5 right x*2 angle 90 location <0,0,-5>}"), 4, 3, rows({49, 158, 212, 251})},
      {"14", stripes("camera{rotate 90*y location <0,0,-5> look_at 0 right x*2 up y*1.5}", 'z'), 4, 1, {251, 212, 158, 49}},
      {"15", stripes("camera{orthographic location <0,0,-5> look_at 0}"), 4, 3, rows({120, 169, 204, 233})},
      {"16", head("camera{}") + "plane{z,4 pigment{gradient x scale 8 translate -4*x}}", 4, 3, rows({137, 173, 201, 225})},
      {"17First", old("location -5*z angle 90 right 2*x up 1.5*y look_at 0"), 4, 1, {230, 141, 223, 125}},
      {"17Last", old("location -5*z right 2*x up 1.5*y look_at 0 angle 90"), 4, 1, {49, 158, 212, 251}},
      {"19", h + "light_source{-10*z 1 color_map{[0.5 rgb x][1 rgb z]}} plane{z,0 pigment{rgb 1} finish{diffuse 1 emission 0}}", 1, 1,
       {188, 0, 255}},
      {"20", group + "}", 1, 1, {0, 255, 0}},
      {"20Global", group + "global_lights}", 1, 1, {255, 255, 0}},
      {"20Half", group + "global_lights .5}", 1, 1, {0, 255, 0}},
      {"20InPlace", h + "light_group{" + lit("y") + inner + "}}", 1, 1, {255, 0, 0}},
      {"20InnerWithoutLights", h + "light_group{" + lit("z") + "light_group{" + lit("y") + "light_group{" + wall + "}}}", 1, 1, {0, 255, 0}},
      {"20Declared", named + "light_group{" + lit("y") + "object{G}}", 1, 1, {255, 255, 0}},
      {"20DeclaredAbove", h + "#declare G=union{light_group{" + lit("y") + inner + "}} sphere{50,1}} object{G}", 1, 1, {255, 255, 0}},
      {"20DeclaredInTwo", named + "light_group{" + lit("z") + "light_group{" + lit("y") + "object{G}}}", 1, 1, {255, 255, 0}},
      {"20DeclaredUnion", h + "#declare G=light_group{" + lit("x") + "union{" + wall + "sphere{50,1}}} light_group{" + lit("y") + "object{G}}",
       1, 1, {255, 0, 0}},
      {"20LooksLike", h + "light_group{" + lit("y") + "light_group{light_source{-10*z rgb x looks_like{" + wall + "translate 10*z}}}}", 1, 1,
       {0, 255, 0}},
      {"20GlobalOfInner", h + lit("z") + "light_group{" + lit("y") + inner + "global_lights}}", 1, 1, {255, 0, 0}},
      {"20GlobalOfOuter", h + lit("z") + "light_group{" + lit("y") + inner + "global_lights off} global_lights}", 1, 1, {255, 0, 255}},
      {"25", h + "background{rgbt<1,1,0,.5>}", 1, 1, {188, 188, 0}},
      {"25Old", "#version 3.6; global_settings{assumed_gamma 1} background{rgbt<1,1,0,.5>}", 1, 1, {255, 255, 0}},
      {"25Float", h + "background{1}", 1, 1, {0, 0, 0}},
      {"26", plain, 1, 1, {128}},
      {"26Gamma", "global_settings{assumed_gamma 1} " + plain, 1, 1, {188}},
  };
}

std::vector<Case> value_cases() {
  const std::string h = "#version 3.7; global_settings{assumed_gamma 1}\n";
  const auto background = [&](const std::string& color) { return h + "background{" + color + "}"; };
  return {
      {"16Rgb", background("rgb .5"), 1, 1, {188}},
      {"16Srgb", background("srgb .5"), 1, 1, {128}},
      {"16Vector", background("rgb<.1,.2,.3>"), 1, 1, {89, 124, 149}},
      {"16Color", background("color .25"), 1, 1, {120}},
      {"16Random", h + "#declare R=seed(42); background{rgb<rand(R),rand(R),rand(R)>}", 1, 1, {221, 155, 225}},
      {"16Spline", h + "#declare S=spline{natural_spline 0,<0,0,0> 1,<1,.5,.2> 2,<.1,.9,.4>} background{rgb S(.7)}", 1, 1, {240, 162, 105}},
      {"17", h + "camera{orthographic location -5*z right 4*x up 3*y direction z} #declare R=seed(7); #for(J,1,-1,-1) #for(I,-1.5,1.5) "
                 "box{<I-.4,J-.4,0>,<I+.4,J+.4,1> pigment{rgb <rand(R),rand(R),rand(R)>} finish{ambient 1 diffuse 0}} #end #end", 4, 3,
       {250, 205, 114, 52, 223, 166, 184, 231, 234, 231, 83, 148, 215, 183, 254, 197, 133, 149, 250, 237, 116, 177, 233, 240,
        186, 185, 240, 215, 193, 191, 148, 238, 70, 242, 196, 137}},
  };
}

class StatementCase : public ::testing::TestWithParam<Case> {};

TEST_P(StatementCase, HasTheMeasuredCodes) { EXPECT_EQ(rendered(GetParam()), GetParam().codes); }

const auto kName = [](const ::testing::TestParamInfo<Case>& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Textures, StatementCase, ::testing::ValuesIn(texture_cases()), kName);
INSTANTIATE_TEST_SUITE_P(Objects, StatementCase, ::testing::ValuesIn(object_cases()), kName);
INSTANTIATE_TEST_SUITE_P(CamerasAndLights, StatementCase, ::testing::ValuesIn(camera_and_light_cases()), kName);
INSTANTIATE_TEST_SUITE_P(Values, StatementCase, ::testing::ValuesIn(value_cases()), kName);

}  // namespace
}  // namespace lute
