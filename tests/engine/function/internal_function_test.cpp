#include "engine/function/internal_function.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace lute {
namespace {

struct Case {
  int index;
  const char* name;
  std::vector<double> parameters;
  double expected;
};

// Specification chapter 21 §11.5, last column: measured with the reference at (0.3, 0.4, -0.2), noise generator 2.
const Case kCases[] = {
    {0, "algbr_cyl1", {1,10,1,0.5,45}, -0.056055485},
    {1, "algbr_cyl2", {1,10,0,0,0}, 0.0342},
    {2, "algbr_cyl3", {1,10,0,0,0}, -0.0625},
    {3, "algbr_cyl4", {1,10,0,0,0}, -0.1065},
    {4, "bicorn", {1,0.5}, -0.0592},
    {5, "bifolia", {1,0.5}, -0.0581},
    {6, "blob", {1,1,1,1,1}, -0.6032},
    {7, "blob2", {1,1,1,1}, -0.249839637},
    {8, "boy_surface", {0.01,1}, -0.134356137},
    {9, "comma", {1}, -0.010102051},
    {10, "cross_ellipsoids", {0.1,2,1.5,0.7}, -0.617143146},
    {11, "crossed_trough", {1}, -0.3964},
    {12, "cubic_saddle", {1}, -0.163},
    {13, "cushion", {1}, 0.0231},
    {14, "devils_curve", {1}, 0.0011},
    {15, "devils_curve_2d", {1,0.5,0.6,0,0,0}, -0.0176},
    {16, "dupin_cyclid", {0.001,4.9,5,2,0,3}, -4.308545338},
    {17, "ellipsoid", {1,2,3}, 1.044030651},
    {18, "enneper", {1}, 0.050520987},
    {19, "flange_cover", {0.1,2,1.5,0.7}, -2.882190074},
    {20, "folium_surface", {1,0.5,2}, 0.47},
    {21, "folium_surface_2d", {1,0.5,2,0,0,0}, -0.43},
    {22, "glob", {1}, -0.194735},
    {23, "heart", {1}, 0.236976},
    {24, "helical_torus", {1,3,2,0.1,0.3,0.4,0.5,1,1,2}, 0.613441711},
    {25, "helix1", {2,8,0.2,0.5,0.5,0.5,30}, 0.059738221},
    {26, "helix2", {1,8,0.2,0.5,0.5,1,0}, 0.617198632},
    {27, "hex_x", {1}, 0.496410162},
    {28, "hex_y", {1}, 0.059807621},
    {29, "hetero_mf", {0.5,2,3.5,0.8,1,2}, 1.283608145},
    {30, "hunt_surface", {0.0001}, 0.449789374},
    {31, "hyperbolic_torus", {1,0.6,0.4}, -0.0961},
    {32, "isect_ellipsoids", {0.1,2,1.5,0.7}, -0.361268731},
    {33, "kampyle_of_eudoxus", {1,0.2,0.4}, -0.19928},
    {34, "kampyle_of_eudoxus_2d", {1,0.2,0.4,0,0,0}, -0.159856},
    {35, "klein_bottle", {1}, -1.626009},
    {36, "kummer_surface_v1", {1}, -0.7209},
    {37, "kummer_surface_v2", {1,0.2,0.3,0.4}, 0.90898},
    {38, "lemniscate_of_gerono", {1}, -0.1181},
    {39, "lemniscate_of_gerono_2d", {1,0.7,0.8,0,0,0}, -0.13696},
    {40, "mesh1", {0.15,0.15,1,0.02,1}, 0.39},
    {41, "mitre", {1}, 0.0236},
    {42, "nodal_cubic", {1}, -0.536},
    {43, "odd", {1}, 0.0231},
    {44, "ovals_of_cassini", {1,0.3,0.5,4}, 0.1524},
    {45, "paraboloid", {1}, 0.27},
    {46, "parabolic_torus", {1,0.6,0.4}, -0.1237},
    {47, "ph", {}, 0.733581324},
    {48, "pillow", {1}, -0.2547},
    {49, "piriform", {1}, 0.1811},
    {50, "piriform_2d", {1,0.5,0.6,0.7,0,0,0}, -0.1510036},
    {51, "poly4", {0.1,0.2,0.3,0.4,0.5}, 0.094155128},
    {52, "polytubes", {5,0.1,0.2,0.3,0.4,0.5}, 0.144251566},
    {53, "quantum", {0}, 1.171829523},
    {54, "quartic_paraboloid", {1}, 0.3903},
    {55, "quartic_saddle", {1}, 0.3935},
    {56, "quartic_cylinder", {1,0.5,0.6}, 0.0224},
    {57, "r", {}, 0.538516481},
    {58, "ridge", {2,3.5,0.5,0.5,0.3,2}, -0.725969661},
    {59, "ridged_mf", {0.5,2,3.5,1,2,2}, 1.469100192},
    {60, "rounded_box", {0.1,0.2,0.3,0.4}, 0.182841712},
    {61, "sphere", {1}, -0.461483519},
    {62, "spikes", {0.1,2,1,0.5,1}, 1.523104423},
    {63, "spikes_2d", {1,2,3,0.5}, -0.238310563},
    {64, "spiral", {0.3,0.05,1,0,0,1}, 0.366906385},
    {65, "steiners_roman", {1}, -0.0004},
    {66, "strophoid", {1,0.5,0.6,0.7}, -0.02472},
    {67, "strophoid_2d", {1,0.5,0.6,0.7,0,0,0}, -0.01272},
    {68, "superellipsoid", {0.5,0.6}, 0.561669399},
    {69, "th", {}, 2.15879893},
    {70, "torus", {0.5,0.2}, 0.223609339},
    {71, "torus2", {1,0.5,0.2}, -0.12},
    {72, "torus_gumdrop", {0.1}, -1.16984},
    {73, "umbrella", {1}, -0.074},
    {74, "witch_of_agnesi", {1,0.5}, 0.248},
    {75, "witch_of_agnesi_2d", {1,0.5,0.6,0,0,0}, 0.464},
    {76, "noise3d", {}, 0.288628846},
    {78, "noise_generator", {2}, 0.288628846},
};

class InternalFunctionValue : public testing::TestWithParam<Case> {};

TEST_P(InternalFunctionValue, EqualsTheReference) {
  const Case& c = GetParam();
  const FunctionPtr function = internal_function(c.index, 2);
  ASSERT_NE(function, nullptr);
  std::vector<double> arguments{0.3, 0.4, -0.2};
  arguments.insert(arguments.end(), c.parameters.begin(), c.parameters.end());
  ASSERT_EQ(function->parameter_count(), static_cast<int>(arguments.size()));
  double value = 0;
  function->evaluate(arguments.data(), &value);
  EXPECT_NEAR(value, c.expected, 1e-8) << c.name;
}

INSTANTIATE_TEST_SUITE_P(Chapter21, InternalFunctionValue, testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(InternalFunction, TableFollowsTheLanguagesNumbering) {
  for (const Case& c : kCases) {
    if (static_cast<std::size_t>(c.index) >= internal_functions().size()) continue;
    EXPECT_EQ(internal_functions()[static_cast<std::size_t>(c.index)].name, c.name);
  }
}

TEST(InternalFunction, UnknownNumbersAreNull) {
  EXPECT_EQ(internal_function(-1, 2), nullptr);
  EXPECT_EQ(internal_function(79, 2), nullptr);
}

}  // namespace
}  // namespace lute
