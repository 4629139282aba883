#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "compare/picture.hpp"
#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"
#include "tests/extreme/extreme_case.hpp"

namespace lute::extreme {
namespace {

constexpr double kTolerance = 2.0 / 255 + 1e-6;

bool differ(const float* pixel, const Rgb& expected) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(std::abs(pixel[c] - expected[c]) <= kTolerance)) return true;
  }
  return false;
}

compare::Picture picture_of(const ExtremeCase& extreme, const std::vector<std::string>& declares,
                            const std::string& program) {
  const compare::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "picture.png";
  compare::ProcessRequest request;
  request.arguments = {program, "+I" + extreme.scene, "+O" + file.string(), "-A", "-D", "+WT1", "+FN8"};
  request.arguments.push_back("+W" + std::to_string(kWidth));
  request.arguments.push_back("+H" + std::to_string(kHeight));
  for (const auto* list : {&extreme.declares, &declares}) {
    for (const std::string& declare : *list) request.arguments.push_back("Declare=" + declare);
  }
  request.working_directory = std::filesystem::path(LUTE_SOURCE_DIR) / "scenes" / "extreme";
  request.time_limit = 300;
  const compare::ProcessResult result = compare::run_process(request);
  if (result.timed_out) throw std::runtime_error("no picture after five minutes");
  if (result.signal != 0) throw std::runtime_error("ended by signal " + std::to_string(result.signal));
  if (!result.succeeded()) throw std::runtime_error("exit code " + std::to_string(result.exit_code));
  return compare::read_picture(file);
}

double share(int count) { return static_cast<double>(count) / (kWidth * kHeight); }

void compare_with(const ClosedForm& oracle, const compare::Picture& picture, Measured& measured) {
  int wrong = 0, undecided = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Real a = (Real{2} * x + 1 - kWidth) / (2 * kWidth), b = (kHeight - Real{2} * y - 1) / (2 * kHeight);
      const std::optional<Rgb> light = oracle(a, b);
      if (!light) {
        ++undecided;
        continue;
      }
      const Rgb expected{compare::srgb_encoded((*light)[0]), compare::srgb_encoded((*light)[1]),
                         compare::srgb_encoded((*light)[2])};
      wrong += differ(picture.at(x, y), expected) ? 1 : 0;
    }
  }
  measured.error = share(wrong);
  measured.undecided = share(undecided);
}

double distance_between(const compare::Picture& a, const compare::Picture& b) {
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      wrong += differ(a.at(x, y), {b.at(x, y)[0], b.at(x, y)[1], b.at(x, y)[2]}) ? 1 : 0;
    }
  }
  return share(wrong);
}

}  // namespace

Measured measure(const ExtremeCase& extreme, const std::string& program) {
  Measured measured;
  std::string now = "first picture";
  try {
    const compare::Picture first = picture_of(extreme, {}, program);
    if (const auto* oracle = std::get_if<ClosedForm>(&extreme.oracle)) {
      compare_with(*oracle, first, measured);
      return measured;
    }
    double worst = 0;
    for (const Variant& variant : std::get<Symmetry>(extreme.oracle)) {
      now = variant.name;
      const double error = distance_between(first, picture_of(extreme, variant.declares, program));
      if (error > worst) measured.worst = now;
      worst = std::max(worst, error);
    }
    measured.error = worst;
  } catch (const std::exception& failure) {
    measured.error = 1;
    measured.failure = now + ": " + failure.what();
  }
  return measured;
}

}  // namespace lute::extreme
