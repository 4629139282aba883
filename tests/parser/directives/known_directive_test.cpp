// What is remembered of loops and macros shows in no result: a body in a loop prints what it prints when it is written out.
#include <gtest/gtest.h>

#include "tests/parser/read_text.hpp"

namespace lute::test {
namespace {

constexpr int kTurns = 6;

// Declared before all bodies; P prints a number, V a vector of what may be a float.
const std::string kSetup =
    "#macro P(A) #debug concat(str(A,0,6),\" \") #end #macro V(A) #debug concat(vstr(5,A,\",\",0,3),\" \") #end\n"
    "#declare S = 0; #declare T = 1; #declare W = <1,2,3>; #declare Arr = array[8]{0,1,2,3,4,5,6,7} #declare R = seed(3);\n"
    "#declare Col = rgb <.1,.2,.3>; #declare f = function(x,y) { x*10+y } #declare Str = \"a\";\n";

struct Outcome {
  std::string printed, error;
  std::size_t warnings = 0;
  bool operator==(const Outcome&) const = default;
};

void PrintTo(const Outcome& o, std::ostream* out) { *out << o.printed << "| " << o.error << " | " << o.warnings << " warnings"; }

Outcome outcome(const std::string& text) {
  const Reading reading = read_text(kSetup + text + "#debug \"\\n\"\n");
  Outcome result{reading.printed, reading.error(), 0};
  for (const Diagnostic& d : reading.diagnostics) result.warnings += d.severity != Severity::kError;
  return result;
}

const char* const kBodies[] = {
    // Values of all kinds, and operators.
    "#declare S = S + I*0.5; P(S)",
    "#declare T = (T + S)/2; #declare S = -S + pow(I,2) - mod(I,3); P(T)",
    "#declare S = (I > 3 ? I : -I); P(S) #declare S = (I = 2 | I = 4) + !(I & 1); P(S)",
    "#declare S = max(I,S,3) + min(I,2) + select(I-3,1,2,3) + int(I/2) + abs(-I) + sin(I); P(S)",
    "#declare S = W.y*I + W.x - W.z; P(S) #declare W = W*2; V(W)",
    "#declare S = Arr[I]*2 + Arr[mod(I,2)] + Arr[Arr[I]]; P(S)",
    "#declare S = f(I,S) + f(1,2); P(S)",
    "#declare S = rand(R); P(S) #declare S = rand(R)*Arr[I]; P(S)",
    "#declare Col = Col*1.1; V(Col) #declare S = Col.red + Col.gray; P(S)",
    "#declare S = 1/(I-3); P(S)",
    "#declare S = sqrt(I-1) + acos(I/3); P(S)",
    "#declare S = 1e-11*I; #if (S) P(1) #else P(0) #end",
    // A name changes its type.
    "#declare S = (I < 3 ? S+1 : S+<1,2,3>); V(S)",
    "#if (I = 3) #declare S = <1,2>; #end #declare S = S*2; V(S)",
    "#if (I = 3) #declare S = \"text\"; #end #if (I > 4) #declare S = I; #end #ifdef (S) P(I) #end",
    "#if (I = 3) #undef T #end #if (I = 5) #declare T = 9; #end #ifdef (T) #declare T = T+1; P(T) #end",
    "#if (I = 4) #undef S #macro S() 7 #end #end #declare T = S(); P(T)",
    "#declare S = I; #if (I = 4) #declare S = array[2]{1,2} #end #if (I < 4) P(S) #end",
    "#if (I = 3) #undef Arr #declare Arr = array[8]{7,6,5,<4,3,2>.x,3,2,1,0} #end #declare S = Arr[I]; P(S)",
    "#if (I = 3) #undef f #declare f = function(x,y) { x-y } #end #declare S = f(I,1); P(S)",
    // Branches.
    "#if (I < 3) P(1) #elseif (I < 5) P(2) #else P(3) #end",
    "#if (I < 3) #if (S) P(1) #else P(2) #end #declare S = I-1; #else #if (I = 4) P(4) #end #end",
    "#if (W.x < I & I < 5) P(I) #end #if (V1 = 1) #end",
    "#ifdef (New) #declare New = New + 1; #else #declare New = 1; #end P(New)",
    // Loops in loops.
    "#declare K = 0; #while (K < I) #declare K = K + 1; #declare S = S + K; #end P(S) P(K)",
    "#declare K = 5; #while (K > I) #declare K = K - 1; #if (K = 2) #break #end #declare S = S + K; #end P(S)",
    "#for (J, I, 1, -1) #declare S = S + J; #if (S > 20) #declare S = 0; #end #end P(S)",
    "#declare K = 0; #while (K < 3) #if (K = 1) #declare K = 2; #else #declare K = K + 1; #end P(K) #end",
    // Macros.
    "#macro Add(A,B) #local L = A + B; #local L = L*2; L #end #declare S = Add(I,S) + Add(1,I); P(S)",
    "#macro Inc(A) #declare A = A + 1; #end Inc(S) Inc(T) Inc(S) P(S) P(T)",
    "#macro Rec(N) #if (N > 0) #local M = N - 1; Rec(M) P(N) #else P(I) #end #end Rec(3)",
    "#macro Shadow() #local S = 5; #declare S = S + I; P(S) #end Shadow() P(S)",
    "#macro Part() I + 1 #end #declare S = 2*Part(); P(S) #declare S = (Part())*2; P(S)",
    "#macro Sum(A) #local X = 0; #local K = 0; #while (K < 3) #local X = X + Arr[K]*A; #local K = K + 1; #end X #end #declare S = Sum(I); P(S)",
    // Directives inside of expressions.
    "#declare S = (I + #declare T = I*2; T); P(S) P(T)",
    "#declare S = (1 + #if (I > 3) 2 #else 3 #end * 4); P(S)",
    "#declare S = I #if (0) +1 #end; P(S)",
    // Errors: the same one, at the same turn.
    "#declare S = Arr[I*2]; P(S)",
    "#declare S = sqrt(3-I); P(S)",
    "#declare S = W.x + Str; P(S)",
    "#if (I = 4) #declare S = <1,2>; #end #if (S) P(1) #end",
    "#declare S = 5 P(S)",
};

class KnownDirective : public ::testing::TestWithParam<const char*> {};

TEST_P(KnownDirective, PrintsWhatTheUnrolledTextPrints) {
  const std::string body = std::string(GetParam()) + "\n";
  std::string unrolled;
  for (int i = 1; i <= kTurns; ++i) unrolled += "#declare I = " + std::to_string(i) + ";\n" + body;
  const Outcome expected = outcome(unrolled);
  EXPECT_EQ(outcome("#for (I, 1, " + std::to_string(kTurns) + ")\n" + body + "#end\n"), expected);
  EXPECT_EQ(outcome("#declare I = 1; #while (I <= " + std::to_string(kTurns) + ")\n" + body + "#declare I = I + 1; #end\n"), expected);
  EXPECT_EQ(outcome("#macro Body() " + body + "#end\n#for (I, 1, " + std::to_string(kTurns) + ") Body() #end\n"), expected);
}

INSTANTIATE_TEST_SUITE_P(All, KnownDirective, ::testing::ValuesIn(kBodies));

}  // namespace
}  // namespace lute::test
