// Long runs of literals in large files are one token until they are read: nothing may show it.
#include <gtest/gtest.h>

#include "tests/parser/read_text.hpp"

namespace lute::test {
namespace {

// Longer than the size from which files count as large.
std::string numbers(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i > 0 ? ",\n" : "") + std::to_string(i);
  return text;
}

std::string vectors(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i > 0 ? ", <" : "<") + std::to_string(i) + ", -0.5, 1e-3>" + (i % 7 == 0 ? "\n" : " ");
  return text;
}

constexpr int kMany = 200'000;
const std::string kMiddle = "#debug concat(str(A[0],0,0),\" \",str(A[123456],0,0),\" \",str(A[199999],0,0),\"\\n\")\n";

TEST(LiteralRun, FillsAnArray) {
  EXPECT_EQ(printed("#declare A = array[200000] {" + numbers(kMany) + "}\n" + kMiddle), "0 123456 199999\n");
  EXPECT_EQ(printed("#declare A = array[200000] {" + vectors(kMany) + "};\n#declare V = A[123456];\n"
                    "#debug concat(vstr(3,V,\",\",0,4),\"\\n\")"),
            "123456.0000,-0.5000,0.0010\n");
}

TEST(LiteralRun, IsReadAgainInMacrosAndLoops) {
  const std::string body = "#declare A = array[200000] {" + numbers(kMany) + "}\n" + kMiddle;
  EXPECT_EQ(printed("#macro M()\n" + body + "#end M() M()"), "0 123456 199999\n0 123456 199999\n");
  EXPECT_EQ(printed("#for (I, 1, 2)\n" + body + "#end"), "0 123456 199999\n0 123456 199999\n");
  EXPECT_EQ(printed("#if (0)\n" + body + "#else #debug \"skipped\\n\" #end"), "skipped\n");
}

TEST(LiteralRun, BelongsToTheExpressionAroundIt) {
  // The run begins behind the `(` and ends in front of the `)`.
  const std::string sum = "#declare S = max(" + numbers(kMany) + ") + 1; #debug concat(str(S,0,0),\"\\n\")";
  EXPECT_EQ(printed(sum), "200000\n");
  EXPECT_EQ(printed("#while (0) #end #for (I, 1, 2) " + sum + " #end"), "200000\n200000\n");
}

TEST(LiteralRun, KeepsThePlacesOfErrors) {
  const Reading behind = read_text("#declare A = array[200000] {" + numbers(100'000) + ",\nfoo" + numbers(100'000) + "}");
  ASSERT_NE(behind.first_error(), nullptr);
  EXPECT_EQ(behind.first_error()->where.line, 100'002u);
  EXPECT_EQ(behind.first_error()->excerpt, "foo0,");
  const Reading inside = read_text("#declare A = array[200000] {" + numbers(100'000) + ",\n1.2.3,\n" + numbers(99'999) + "}");
  ASSERT_NE(inside.first_error(), nullptr);
  EXPECT_EQ(inside.first_error()->message, "Unexpected additional '.' in floating-point number");
  EXPECT_EQ(inside.first_error()->where.line, 100'002u);
  EXPECT_EQ(inside.first_error()->where.column, 4u);
}

TEST(LiteralRun, GoesOnBehindAnErrorInIt) {
  const Reading reading = read_text("sphere { " + vectors(kMany) + "}\nbox { foo }");
  std::vector<std::uint32_t> lines;
  for (const Diagnostic& d : reading.diagnostics) {
    if (d.severity == Severity::kError) lines.push_back(d.where.line);
  }
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], 3u);  // a radius is expected behind the first vector and its line end
  EXPECT_EQ(lines[1], 28'575u);  // 200,000 vectors, seven in a line, behind the first
}

TEST(LiteralRun, GivesMeshesTheirVertices) {
  std::string vertices, faces;
  for (int i = 0; i < 60'000; ++i) {
    vertices += ",<" + std::to_string(i) + ",1,2>";
    if (i + 2 < 60'000) faces += ",<" + std::to_string(i) + "," + std::to_string(i + 1) + "," + std::to_string(i + 2) + ">";
  }
  ParseOptions options;
  options.input_file = "test.pov";
  options.input_text = "#version 3.7;\nmesh2 { vertex_vectors { 60000" + vertices + " } face_indices { 59998" + faces + " } }";
  const ParseResult result = parse_scene(options);
  ASSERT_TRUE(result.ok);
  ASSERT_EQ(result.scene.objects.size(), 1u);
  const MeshData& data = *result.scene.objects.front()->shape_if<Mesh>()->data;
  ASSERT_EQ(data.vertices.size(), 60'000u);
  ASSERT_EQ(data.faces.size(), 59'998u);
  for (std::uint32_t i = 0; i < data.faces.size(); ++i) {
    ASSERT_EQ(data.vertices[i].x, static_cast<float>(i));
    ASSERT_EQ(data.faces[i][2], i + 2);
  }
}

}  // namespace
}  // namespace lute::test
