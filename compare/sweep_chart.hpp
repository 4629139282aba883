// Error over processor time as a log–log chart: one curve a program and method, the Pareto front as a broad line.
#pragma once

#include <ostream>

#include "compare/sweep.hpp"

namespace lute::compare {

// One <svg> element that stands in a page or, with its own colours, in a file alone. Nothing without points.
void write_chart(std::ostream& out, const Sweep& sweep);

}  // namespace lute::compare
