#include "compare/large_scenes.hpp"

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace lute::compare {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

File open(const std::filesystem::path& path) {
  File file(std::fopen(path.c_str(), "wb"));
  if (!file) throw std::runtime_error("cannot write " + path.string());
  return file;
}

constexpr const char* kHead = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n";

}  // namespace

void write_loop(const std::filesystem::path& path, std::int64_t turns) {
  const File file = open(path);
  std::fprintf(file.get(),
               "%s#declare I = 0;\n#declare Sum = 0;\n#declare Mean = 1;\n"
               "#while (I < %lld)\n  #declare Sum = Sum + I*0.5;\n  #declare Mean = (Mean + Sum)/2;\n  #declare I = I + 1;\n#end\n"
               "sphere { <Sum, Mean, 0>, 1 }\n",
               kHead, static_cast<long long>(turns));
}

void write_mesh(const std::filesystem::path& path, std::int64_t faces) {
  const auto side = static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(faces) / 2)));
  const std::int64_t row = side + 1;
  const File file = open(path);
  std::FILE* const out = file.get();
  std::fprintf(out, "%smesh2 {\n  vertex_vectors {\n    %lld", kHead, static_cast<long long>(row * row));
  for (std::int64_t i = 0; i < row; ++i) {
    for (std::int64_t j = 0; j < row; ++j) {
      const double u = static_cast<double>(i) / static_cast<double>(side), v = static_cast<double>(j) / static_cast<double>(side);
      std::fprintf(out, ",\n    <%.6f, %.6f, %.6f>", u, v, std::sin(9 * u) * std::cos(7 * v));
    }
  }
  std::fprintf(out, "\n  }\n  face_indices {\n    %lld", static_cast<long long>(2 * side * side));
  for (std::int64_t i = 0; i < side; ++i) {
    for (std::int64_t j = 0; j < side; ++j) {
      const long long a = i * row + j, b = a + 1, c = a + row, d = c + 1;
      std::fprintf(out, ",\n    <%lld, %lld, %lld>,\n    <%lld, %lld, %lld>", a, b, c, b, d, c);
    }
  }
  std::fprintf(out, "\n  }\n}\n");
}

}  // namespace lute::compare
