// What a sweep says in one number: the processor time of lute's method 3, +AM3, as a share of that of POV-Ray's method
// 2 at equal error.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "compare/sweep.hpp"

namespace lute::compare {

struct EqualError {
  std::string setting;       // of a point of POV-Ray, on the front of its method 2
  double rmse = 0;           // its error
  double reference_cpu = 0;  // seconds
  double own_cpu = 0;        // seconds of +AM3 for the same error
  double share() const { return own_cpu / reference_cpu; }
};

// The time at which a curve reaches an error, on straight lines of the log–log chart between its points. Where the
// cheapest point is already better, its time; none where the dearest is not good enough.
std::optional<double> time_at_error(std::vector<const SweepPoint*> curve, double rmse);

std::vector<EqualError> at_equal_error(const Sweep& sweep);
// The median share; none if no point can be compared.
std::optional<double> time_share(const Sweep& sweep);
// The largest share; none if no point can be compared.
std::optional<double> largest_share(const Sweep& sweep);

// "At equal error +AM3 needs at most half of the processor time of POV-Ray's +AM2 in every setting compared on 3 of 10 scenes, in the
// middle one of the settings of a scene (their median) on 8." Empty without a comparison.
std::string summary(const std::vector<Sweep>& sweeps);

// The summary and a table of all that is compared at equal error, for a page in docs/.
void write_markdown(std::ostream& out, const std::vector<Sweep>& sweeps, const std::string& circumstances);
// A table of every point, for a page in docs/.
void write_points(std::ostream& out, const std::vector<Sweep>& sweeps, const std::string& circumstances);

}  // namespace lute::compare
