// Every include file of the package povray-includes is read as it is, with the real engine behind pattern functions and traces.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/build/geometry_answers.hpp"
#include "engine/texture/texture_functions.hpp"
#include "parser/parse.hpp"

namespace lute {
namespace {

const std::string kFolder = "/usr/share/povray-3.7/include";

std::vector<std::string> standard_includes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder))
    if (entry.path().extension() == ".inc") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

TEST(StandardIncludes, AreRead) {
  const std::vector<std::string> names = standard_includes();
  EXPECT_GE(names.size(), 39u);  // of povray-includes 3.7.0.10
  for (const std::string& name : names) {
    GeometryAnswers geometry;
    CompiledTextureFunctions functions(make_inside_test);
    ParseOptions options;
    options.input_file = "test.pov";
    // Some of them use colours and shapes without including them; POV-Ray, too, rejects those alone.
    options.input_text = "#version 3.7; global_settings { assumed_gamma 1 }\n#include \"colors.inc\"\n#include \"shapes.inc\"\n"
                         "#include \"" + name + ".inc\"\n";
    options.library_paths = {kFolder};
    options.geometry = &geometry;
    options.texture_functions = &functions;
    const ParseResult result = parse_scene(options);
    EXPECT_TRUE(result.ok) << name << ": " << (result.diagnostics.empty() ? std::string() : result.diagnostics.back().message);
  }
}

}  // namespace
}  // namespace lute
