// Check cases 1-7, 12, 13, 19 of the specification's chapter 10 §14.
#include <gtest/gtest.h>

#include "tests/parser/read_text.hpp"

namespace lute::test {
namespace {

// The reference's binary: behind the fifth component no comma may stand, and further ones take its place.
TEST(Vector, LastComponentWithoutCommaTakesThePlaceOfTheFifth) {
  const auto color = [](const std::string& vector) {
    return printed("#declare V=" + vector + "; #debug concat(str(V.red,0,0),str(V.blue,0,0),str(V.filter,0,0),str(V.transmit,0,0),\"\\n\")");
  };
  EXPECT_EQ(color("<1, 2 3 4 5 6>"), "1346\n");
  EXPECT_EQ(color("<1 2 3 4, 5 6 7>"), "1347\n");
  EXPECT_EQ(color("<1,2,3,4,5 -6>"), "134-1\n");
  EXPECT_EQ(printed("#for (I,1,3) #declare V=<1,2,3,4,5 I>; #debug str(V.transmit,0,0) #end #debug \"\\n\""), "123\n");
  for (const char* vector : {"<1,2,3,4,5,6>", "<1,2,3,4,5,>", "<1,2,3,4,5 6,7>"}) {
    EXPECT_EQ(color(vector), "error: Expected '>', ,  found instead") << vector;
  }
  EXPECT_EQ(color("<1,2,3,4,>.filter*<1,0,0,0,1>"), "4004\n");
}

TEST(Random, FollowsTheReferencesGenerator) {
  EXPECT_EQ(printed("#macro P(V) #debug concat(str(V,0,12),\"\\n\") #end\n#declare S=seed(0); P(rand(S)) P(rand(S)) P(rand(S))\n"
                    "#declare S=seed(12345); P(rand(S))\n#declare S=seed(-1); P(rand(S))"),
            "0.000002874294\n0.466563684509\n0.249070228834\n0.466563684509\n0.578012873553\n");
  EXPECT_EQ(error_of("#declare A=rand(3);"), "Illegal random number generator.");
}

TEST(Expression, HasTheReferencesPrecedence) {
  const std::pair<const char*, const char*> cases[] = {
      {"(1|0&0)", "0"}, {"(0&0|1)", "1"}, {"(1<2<3)", "1"}, {"(3>2>1)", "0"}, {"(2=2=2)", "0"}, {"2-3-4", "-5"}, {"8/4/2", "1"},
      {"-2*3+1", "-5"}, {"!1+1", "1"}, {"-2-3*2", "-8"}, {"--2", "2"}, {"-x.x", "-1"}, {"2*-3", "-6"}, {"(0?1:0?2:3)", "3"}};
  for (const auto& [text, value] : cases) EXPECT_EQ(float_text(text, 0), value) << text;
}

TEST(Expression, ComparesWithTheLanguagesTolerance) {
  EXPECT_EQ(float_text("(1=1+1e-11)", 0), "1");
  EXPECT_EQ(float_text("(1=1+1e-9)", 0), "0");
  EXPECT_EQ(float_text("(1<=1-1e-11)", 0), "1");
  EXPECT_EQ(float_text("(1<1+1e-11)", 0), "1");
  EXPECT_EQ(float_text("(1e-11?1:0)", 0), "0");
}

TEST(Expression, PromotesVectors) {
  EXPECT_EQ(vector_text("<1,2>+<1,1,1>"), "2.000000,3.000000,1.000000");
  EXPECT_EQ(vector_text("1/<1,2,4>"), "1.000000,0.500000,0.250000");
  EXPECT_EQ(vector_text("(2 > <1,2,3>)"), "1.000000,0.000000,0.000000");
  EXPECT_EQ(vector_text("!<1,0,3>"), "0.000000,1.000000,0.000000");
  EXPECT_EQ(vector_text("<1,2>+<1,2,3,4>", 4), "2.000000,4.000000,3.000000,4.000000");
  EXPECT_EQ(vector_text("t+x", 4), "1.000000,0.000000,0.000000,1.000000");
  EXPECT_EQ(vector_text("<1 -2 3>", 2), "-1.000000,3.000000");
  EXPECT_EQ(float_text("(0?<1,2,3>:4)", 0), "4");
}

TEST(Expression, FormatsNumbersAsText) {
  EXPECT_EQ(printed("#debug concat(str(3.14159,0,-1),\"|\",str(3.14159,10,3),\"|\",str(3.14159,-10,3),\"|\",str(2.5,0,0),\"\\n\")"),
            "3.141590|     3.142|000003.142|2\n");
}

TEST(Expression, RotatesAndPerturbsVectors) {
  EXPECT_EQ(vector_text("vrotate(<1,2,3>,<10,20,30>)"), "1.067425,2.289059,2.760581");
  EXPECT_EQ(vector_text("vaxis_rotate(<1,2,3>,<1,1,1>,30)"), "1.422650,1.422650,3.154701");
  EXPECT_EQ(vector_text("vturbulence(2,0.5,6,<0.3,0.7,1.1>)"), "0.344564,-0.261187,-0.078804");
}

TEST(Expression, ComputesIntegersInThirtyTwoBits) {
  const std::pair<const char*, const char*> cases[] = {
      {"mod(-7,3)", "-1"}, {"mod(7,-3)", "1"}, {"int(-2.7)", "-2"}, {"div(-7,2)", "-3"}, {"int(3e9)", "-2147483648"},
      {"bitwise_and(12,10)", "8"}, {"bitwise_or(12,10,1)", "15"}, {"bitwise_xor(12,10)", "6"}, {"1/0", "inf"}, {"-1/0", "inf"}};
  for (const auto& [text, value] : cases) EXPECT_EQ(float_text(text, 0), value) << text;
}

TEST(Expression, TakesTheValueOfANameWhereItStands) {
  EXPECT_EQ(printed("#declare B=2; #declare A=(B + #declare B=7; B);#debug str(A,0,0) #debug \"\\n\""), "9\n");
  EXPECT_EQ(printed("#macro Sq(V) #local R=V*V; R #end #declare A=Sq(2)+Sq(3);#debug concat(str(A,0,0),\"\\n\")"), "13\n");
}

TEST(Expression, ComparesStrings) {
  EXPECT_EQ(float_text("(\"a\"=\"a\" & 1)", 0), "1");
  EXPECT_EQ(float_text("strcmp(\"abc\",\"ab\")", 0), "99");
  EXPECT_EQ(float_text("strcmp(\"\",\"a\")", 0), "-97");
  EXPECT_EQ(float_text("val(\"0x1f\")", 0), "31");
  EXPECT_EQ(printed("#debug concat(datetime(0),\"\\n\")"), "2000-01-01 00:00:00Z\n");
  // Measured with POV-Ray 3.7.
  EXPECT_EQ(printed("#debug concat(datetime(1/0),\"\\n\")"), "1970-01-01 00:00:00Z\n");
  EXPECT_EQ(printed("#debug concat(datetime(1e6),\"\\n\")"), "4737-11-28 00:00:00Z\n");
  EXPECT_EQ(error_of("#debug datetime(-1e6)"), "Year is out of valid range: 1400..9999");
  EXPECT_EQ(error_of("#debug datetime(1e7)"), "Year is out of valid range: 1400..9999");
  EXPECT_EQ(printed("#debug concat(datetime(0,\"%Z|%z|%Y%%Z\"),\"\\n\")"), "||2000%Z\n");
}

// The lengths were printed by POV-Ray 3.7.
TEST(Expression, TextIsAsLongAsInTheReference) {
  EXPECT_EQ(float_text("strlen(chr(0))", 0), "0");
  EXPECT_EQ(float_text("strlen(concat(\"a\", chr(0), \"b\"))", 0), "2");
  EXPECT_EQ(float_text("strlen(\"x\\u0000y\")", 0), "1");
  EXPECT_EQ(float_text("strlen(\"a\r\nb\rc\nd\")", 0), "7");
  const auto utf8_length = [](const std::string& bytes) {
    return printed("global_settings { charset utf8 } #debug concat(str(strlen(\"" + bytes + "\"), 0, 0), \"\\n\")");
  };
  EXPECT_EQ(utf8_length("a\xe9" "bcde"), "4\n");
  EXPECT_EQ(utf8_length("a\xc3" "bcde"), "5\n");
  EXPECT_EQ(utf8_length("a\xf0" "bcdef"), "4\n");
  EXPECT_EQ(utf8_length("a\xe2\x82"), "2\n");
  EXPECT_EQ(utf8_length("a\x80\x80z"), "4\n");
  EXPECT_EQ(error_of("global_settings { charset sys } #debug \"\xe9\""), "Cannot convert system specific text format to Unicode.");
}

TEST(Colour, FillsComponentsByItsForm) {
  const auto color = [](const std::string& text) {
    return printed("#declare C1=rgb<1,.5,.25>; #declare C=" + text + "; #debug concat(vstr(5,C,\",\",0,2),\"\\n\")");
  };
  EXPECT_EQ(color("rgbt<.1,.2,.3,.4>"), "0.10,0.20,0.30,0.00,0.40\n");
  EXPECT_EQ(color("rgbft 0.25"), "0.25,0.25,0.25,0.25,0.25\n");
  EXPECT_EQ(color("rgbt 0.25"), "0.25,0.25,0.25,0.00,0.25\n");
  EXPECT_EQ(color("color .5"), "0.50,0.50,0.50,0.50,0.50\n");
  EXPECT_EQ(color("color red 1 filter 0.5"), "1.00,0.00,0.00,0.50,0.00\n");
  EXPECT_EQ(color("color C1 green .9"), "1.00,0.90,0.25,0.00,0.00\n");
  EXPECT_EQ(color("C1+1"), "2.00,1.50,1.25,1.00,1.00\n");
  EXPECT_EQ(printed("#declare C=rgb 0.3; #debug concat(str(C.red,0,10),\"\\n\")"), "0.3000000119\n");
  EXPECT_EQ(printed("#declare C=srgb 0.5; #debug concat(str(C.red,0,5),\"\\n\")"), "0.21404\n");
}

TEST(UserFunction, IsCompiledAsTheReferenceDoes) {
  const auto value = [](const std::string& function, const std::string& call, int digits) {
    return printed("#declare f=" + function + "\n#debug concat(str(f" + call + ",0," + std::to_string(digits) + "),\"\\n\")");
  };
  EXPECT_EQ(value("function(x){x/3}", "(5)", 18), "1.666666666666666519\n");
  EXPECT_EQ(value("function(a){x+a}", "(5)", 0), "5\n");
  EXPECT_EQ(value("function(n){sum(i,1,n,i*i)}", "(4)", 0), "30\n");
  EXPECT_EQ(value("function{x+y*2}", "(1,2,0)", 0), "5\n");
  EXPECT_EQ(value("function(x){ln(x)}", "(0)", 0), "-inf\n");
  EXPECT_EQ(value("function{1|0&0}", "(0,0,0)", 0), "1\n");
  EXPECT_EQ(value("function(x){x=1}", "(1+1e-12)", 0), "0\n");
  EXPECT_EQ(value("function(x){x<2=1}", "(1)", 0), "0\n");
  EXPECT_EQ(value("function{spline{0,<1,2> 1,<3,4>}}", "(.5).y", 0), "3\n");
}

TEST(UserFunction, RefusesWhatTheReferenceRefuses) {
  EXPECT_EQ(error_of("#declare f=function(x){!x}"), "Expected 'sign or operand', ! found instead");
  EXPECT_EQ(error_of("#declare f=function(x){abs(x,1)}"),
            "Invalid number of parameters for 'abs': Only one parameter expected!");
  EXPECT_EQ(error_of("#declare f=function(x){x/0}"), "Division by zero.");
  EXPECT_EQ(error_of("#declare f=function{internal(999)}"), "Function 'internal(999)' does not exist.");
  EXPECT_EQ(error_of("#declare f=function(x){x} #declare f=function(x){x}"),
            "Redeclaring functions is not allowed - #undef the function first!");
}

TEST(Expression, RefusesWhatTheReferenceRefuses) {
  EXPECT_EQ(error_of("#declare A=<1,2>; #declare A=A.z;"), "Bad operands for period operator.");
  EXPECT_EQ(error_of("#declare A=array[2]; #declare B=A[-1];"), "Negative subscript");
  EXPECT_EQ(error_of("#declare A=sqr(3);"), "Expected 'RValue to declare', sqr found instead");
  EXPECT_EQ(error_of("#declare A=(0 ? sqrt(-1) : 2);"), "sqrt of negative number -1.000000");
  EXPECT_NE(error_of("#declare A=str(1<2,0,0);"), "");
  EXPECT_NE(error_of("#declare A=1=1;"), "");
}

TEST(Expression, BoundsItsRecursion) {
  const auto nested = [](const std::string& open, std::size_t count) {
    std::string text = "#declare Q=array[2]; #macro M(A) A #end #declare A=";
    for (std::size_t i = 0; i < count; ++i) text += open;
    return text + "1";
  };
  for (const char* open : {"(", "-", "sin(", "<1,", "Q[", "array[2]{", "(1?1:", "concat(", "function{(", "M(", "(#declare A="}) {
    EXPECT_FALSE(read_text(nested(open, 100'000)).ok) << open;
  }
}

// The same expressions parsed (outside) and run from code (inside a loop) give the same values, also when a name changes type.
TEST(CompiledExpression, AgreesWithTheParsedOne) {
  EXPECT_EQ(printed("#declare A=array[3]{1,2,3} #declare V=<1,2,3>; #declare f=function(x){x*x}\n"
                    "#declare S=spline{0,<0,0> 1,<2,4>}\n"
                    "#for(I,0,2) #debug concat(str(A[I]*2-V.y+f(I)+S(I/2).y+max(I,1)+(I=1?10:20)+dimension_size(A,1),0,3),\" \") #end\n"
                    "#debug \"\\n\""),
            "24.000 19.000 37.000 \n");
  EXPECT_EQ(printed("#declare Q=array[2]; #declare Q[0]=1; #declare Q[1]=2;\n"
                    "#for(I,1,4) #declare X=I; #if(I>2) #declare X=<I,I,I>; #end #debug concat(vstr(3,X*2,\",\",0,0),\" \") #end\n"
                    "#debug \"\\n\""),
            "2,0,0 4,0,0 6,6,6 8,8,8 \n");
}

}  // namespace
}  // namespace lute::test
