// What varies along a curve of a sweep: settings of one name make one curve.
#pragma once

#include <string>

namespace lute::compare {

// The antialiasing that a group of switches asks for, as both programs read them: "no antialiasing", "method 1" … "method 3". Later
// switches win; `Antialias=off`, `Sampling_Method=3` and the long forms of lute count as well.
std::string method_of(const std::string& switches);

// The method, and the names of all else that is set: "method 2, Accuracy" for "+AM2 +A0.1 Declare=Accuracy=0.01".
std::string curve_of(const std::string& switches);

}  // namespace lute::compare
