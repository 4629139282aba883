// Check cases 8, 9, 11, 15, 18, 20 of the specification's chapter 10 §14, and its §2-§6.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "parser/machine_memory.hpp"
#include "tests/file_text.hpp"
#include "tests/parser/read_text.hpp"

namespace lute::test {
namespace {

constexpr const char* kPrint = "#macro P(V) #debug concat(str(V,0,6),\"\\n\") #end\n";

std::string values(const std::string& text) { return printed(kPrint + text); }

TEST(ForLoop, CountsWithTheLanguagesTolerance) {
  EXPECT_EQ(values("#declare N=0; #for(I,1,2,0.1) #declare N=N+1; #end P(N) P(I)"), "11.000000\n2.100000\n");
  EXPECT_EQ(values("#for(K,3,1) #error \"no\" #end P(K)"), "3.000000\n");
  EXPECT_EQ(values("#for(K,3,1,-1) #end P(K)"), "0.000000\n");
  EXPECT_EQ(values("#declare N=0; #for(I,1,3) #declare I=I+1; #declare N=N+1; #end P(N)"), "2.000000\n");
  EXPECT_EQ(error_of("#for(I,1,2,0) #end"), "#for loop increment must be non-zero.");
}

TEST(Switch, FallsThroughFromTheFirstMatch) {
  const std::string macro =
      "#macro S(q) #switch(q) #case(1) #debug \"a\" #break #case(2) #debug \"b\" #range(2.5,4) #debug \"c\" #else #debug \"d\" #end "
      "#debug \"\\n\" #end\n";
  EXPECT_EQ(printed(macro + "S(2) S(3) S(9) S(1)"), "bcd\ncd\nd\na\n");
  EXPECT_EQ(error_of("#switch(1) foo #end"), "#switch not followed by #case or #range.");
}

TEST(Macro, PassesLoneIdentifiersByReference) {
  EXPECT_EQ(values("#macro pm(A) #declare A=A+1; #end #declare Q=5; pm(Q) P(Q) pm(Q+0) P(Q)"), "6.000000\n6.000000\n");
  EXPECT_EQ(values("#macro loc(A) #local A=99; #end #declare Q=1; loc(Q) P(Q)"), "99.000000\n");
  EXPECT_EQ(values("#macro el(A) #declare A=7; #end #declare Q=array[2]{1,2} el(Q[1]) P(Q[1])"), "7.000000\n");
  EXPECT_EQ(printed("#macro sw(A,B) #local T=A; #declare A=B; #declare B=T; #end #declare A1=1; #declare B1=<1,2,3>; sw(A1,B1)\n"
                    "#debug concat(vstr(3,A1,\",\",0,0),str(B1,0,0),\"\\n\")"),
            "1,2,31\n");
}

TEST(Macro, SuppliesTokensNotAValue) {
  EXPECT_EQ(values("#macro part() 2+3 #end P(part()*2)"), "8.000000\n");
  EXPECT_EQ(values("#macro MM(A,B) A-B #end #declare V=MM(1,-2); P(V) #declare V=MM(1 -2,3); P(V)"), "3.000000\n-4.000000\n");
  EXPECT_EQ(values("#macro M() 5 #end #declare A=M(); P(A)"), "5.000000\n");
}

TEST(Macro, AsAValueLeavesTheNameInTheScopeOfItsDirective) {
  // The value's macro has not ended when the value is complete: as in transforms.inc, Spline_Trans.
  EXPECT_EQ(values("#macro V() sphere { 0, 1 } #end #macro Out() #local S = V() #ifdef(S) P(1) #end #end Out()"), "1.000000\n");
  EXPECT_EQ(values("#macro V() 5; #end #macro Out() #local L = V() P(L) #end Out() #ifdef(L) P(9) #end"), "5.000000\n");
  EXPECT_EQ(values("#macro V() #local L = 1; L + 1; #end #declare L = 0; #declare L = V() P(L)"), "2.000000\n");
}

TEST(Hash, WithoutADirectiveIsPassedOver) {  // the reference's binary: only a number behind it is an error
  EXPECT_TRUE(read_text("camera { location <0,0,-4># } # sphere { 0, 1 # }").ok);
  EXPECT_EQ(error_of("sphere { 0, # 1 }"), "Expected 'object or directive.', float function 'float constant' found instead");
  EXPECT_EQ(error_of("# foo"), "Expected 'object or directive', undeclared identifier 'foo' found instead");
}

TEST(Macro, SeesTheLocalsOfItsCaller) {
  EXPECT_EQ(values("#macro In() P(L) #declare L=2; #end #macro Out() #local L=1; In() P(L) #end Out() #ifdef(L) P(9) #end"),
            "1.000000\n2.000000\n");
}

TEST(Macro, RecursesToTheReferencesDepth) {
  const std::string macro = "#macro R(n) #if(n>1) R(n-1) #end #end\n";
  EXPECT_TRUE(read_text(macro + "R(98)").ok);
  EXPECT_EQ(error_of(macro + "R(99)"), "Too many nested symbol tables");
}

TEST(Break, LeavesTheInnermostLoopSwitchOrMacro) {
  EXPECT_EQ(values("#declare M=3; #while(M>0) #declare M=M-1; #if(M=1) #break #end #end P(M)"), "1.000000\n");
  EXPECT_EQ(values("#macro E(n) #if(n) #break #end P(n) #end E(1) E(0)"), "0.000000\n");
  EXPECT_EQ(error_of("#break"), "Invalid context for #break");
}

// What POV-Ray 3.7 does with these scenes.
TEST(Switch, RunsDirectivesInFrontOfItsFirstCase) {
  EXPECT_EQ(values("#switch(2) P(1) #declare A=5; #case(1) P(7) #break #case(2) P(2) #break #end P(A)"), "1.000000\n2.000000\n5.000000\n");
  EXPECT_EQ(values("#switch(2) #for(I,1,2) P(I) #end #if(0) P(8) #else P(9) #end #range(1,3) P(3) #end"),
            "1.000000\n2.000000\n9.000000\n3.000000\n");
  EXPECT_EQ(error_of("#switch(2) sphere { 0, 1 } #case(2) #end"), "#switch not followed by #case or #range.");
  EXPECT_EQ(error_of("#switch(2) #if(1) #end #else #end"), "Mis-matched '#else'.");
  EXPECT_EQ(error_of("#switch(2) #debug \"x\" #end"), "Mis-matched '#end'.");
  EXPECT_EQ(error_of("#switch(2) #if(1) #case(2) #end #end"), "Mis-matched '#case' or '#range'.");
  EXPECT_EQ(error_of("#while(1) #switch(2) #break #case(2) #end #end"), "Mis-matched '#end'.");
}

TEST(Skipping, IgnoresEverythingButNesting) {
  EXPECT_EQ(printed("#ifndef(pi_undefined_name) #debug \"ok\\n\" #else x y #foo zzz \"str #end\" $ % #end"), "ok\n");
  EXPECT_EQ(printed("#if(0) /* #end */ // #end\n\"#end\" #end #debug \"ok\\n\""), "ok\n");
  EXPECT_EQ(printed("#if(0) #while(1) #macro M() #end #end a #elseif(1) #debug \"e\\n\" #else b #end"), "e\n");
}

TEST(Directives, RunInTheMiddleOfAnExpression) {
  EXPECT_EQ(values("#declare A=(1 + #if(1) 2 #else 3 #end *4); P(A)"), "9.000000\n");
  EXPECT_EQ(values("#declare A = #if(1) 5; #end P(A)"), "5.000000\n");
  EXPECT_NE(error_of("#declare A=1 #if(1) +2 #end ;"), "");
  EXPECT_NE(error_of("#declare A = #if(1) 5 #else 6 #end;"), "");
}

// Probes of the reference's binary. So a macro's value may end with `;` and its call too.
TEST(Declare, PassesOverASecondSemicolonBehindNumbers) {
  const std::string third = "Expected 'object or directive', ; found instead";
  EXPECT_EQ(error_of("#declare A = 1;; #local B = <1, 2>; ; #declare C = rgb 1;; #declare D = array[1] #declare D[0] = 1;;"), "");
  EXPECT_EQ(error_of("#declare A = 1;;;"), third);
  EXPECT_EQ(error_of("#declare A = \"a\";;"), third);
  EXPECT_EQ(error_of("#declare A = sphere { 0, 1 };;"), third);
  EXPECT_EQ(values("#macro T(A) 2*A; #end #declare B = T(2); P(B)"), "4.000000\n");
  EXPECT_EQ(values("#macro T() 2; #end #macro U() T() #end #declare B = U(); P(B)"), "2.000000\n");
  EXPECT_EQ(values("#macro T() 2; #end #for (I, 1, 3) #declare B = T(); #declare B = B + I;; P(B) #end"), "3.000000\n4.000000\n5.000000\n");
  EXPECT_EQ(error_of("#macro T() #local X = 2; #end T();"), "");
  EXPECT_EQ(error_of("#macro T() #local X = 2; #end #for (I, 1, 3) T(); #end"), "");
  EXPECT_EQ(error_of("#macro T() #local X = 2; #end T(); #declare Y = X;"), "Cannot assign uninitialized identifier.");
  // No directive is executed for it.
  EXPECT_EQ(error_of("#if (1) #declare A = 1; #end ;"), third);
  EXPECT_EQ(error_of("#macro T() 2; #if (1) #end #end #declare B = T();"), third);
  EXPECT_EQ(error_of("#macro T() ; #end #declare B = 2; T()"), third);
}

TEST(Declare, NeedsItsSemicolonBehindNumbersOnly) {
  EXPECT_EQ(error_of("#declare A=5").substr(0, 60), "All #declares of float, vector, and color require semi-colon");
  EXPECT_TRUE(read_text("#declare A=\"s\" #declare A=\"s\";").ok);
  EXPECT_EQ(error_of("#declare v=3;"), "Expected 'undeclared identifier', float function 'v' found instead");
}

TEST(Array, ElementsWithoutValueCannotBeUndefined) {
  EXPECT_EQ(error_of("#declare A=array[2] #undef A[1]"), "Attempt to access uninitialized array element.");
  EXPECT_EQ(values("#declare A=array[2]{1,2} #undef A[1] #ifdef(A[1]) P(1) #else P(0) #end #declare A[1]=7; P(A[1])"),
            "0.000000\n7.000000\n");
}

TEST(Array, KeepsItsElementType) {
  EXPECT_EQ(error_of("#declare A=array[2] #declare A[0]=1; #declare A[1]=<1,2,3>;"),
            "Attempted to redefine float identifier as vector identifier.");
  EXPECT_EQ(error_of("#declare A=array[2]; #declare A[0]=1; #undef A[0] #declare A[1]=<1,2,3>;"),
            "Attempted to redefine float identifier as vector identifier.")
      << "also when no element is left";
  EXPECT_EQ(error_of("#declare A=array[1] #declare A[0]=\"a\" #undef A[0] #declare A[0]=1;"),
            "Attempted to redefine string identifier as float identifier.");
  EXPECT_NE(error_of("#declare A=array[3]{1,2}"), "");
  EXPECT_NE(error_of("#declare A=array[1]{1,2}"), "");
  EXPECT_EQ(values("#declare A=array[2]{1,2} #declare B=A; #declare B[0]=9; P(A[0]) P(dimensions(B))"), "1.000000\n1.000000\n");
}

// The reference's binary: a parameter goes on being the element, whatever else happens to the array. Of elements that get another type
// that way it reads rubbish; here each has the type of its value.
TEST(Array, ElementsPassedByReferenceStayElements) {
  EXPECT_EQ(values("#macro M(E) #declare E=7; P(Q[1]) #declare Q[1]=8; P(E) #undef Q[1] #declare Q[1]=9; P(E) #end\n"
                   "#declare Q=array[2]{1,2} M(Q[1]) P(Q[1]) P(Q[0])"),
            "7.000000\n8.000000\n9.000000\n9.000000\n1.000000\n");
  EXPECT_EQ(values("#macro M(E,F) #declare E=E+1; #declare F=F*10; #end #declare Q=array[2]{1,2} M(Q[1],Q[1]) P(Q[1])\n"
                   "M(Q[0],Q[1]) P(Q[0]) P(Q[1])"),
            "30.000000\n2.000000\n300.000000\n");
  EXPECT_EQ(values("#macro M(E) #declare E=7; #declare C=Q; #declare E=8; P(C[0]) #end #declare Q=array[1]{1}\n"
                   "M(Q[0]) P(C[0]) P(Q[0])"),
            "7.000000\n7.000000\n8.000000\n");
  EXPECT_EQ(printed("#macro M(E) #declare E=\"text\" #end #declare Q=array[3]{1,2,3} M(Q[1])\n"
                    "#debug concat(str(Q[0],0,0),Q[1],str(Q[2],0,0),\"\\n\") #declare R=Q; #debug concat(R[1],\"\\n\")"),
            "1text3\ntext\n");
}

// 8 bytes for a float and 24 for a vector, and what marks the elements that have a value: the process must not grow by three times
// that while a million elements are filled.
TEST(Array, OfNumbersLiesPacked) {
  const auto growth = [](const std::string& value) {
    ParseOptions options;
    const std::uint64_t before = resident_bytes();
    std::uint64_t after = 0;
    options.on_debug = [&](std::string_view) { after = resident_bytes(); };
    options.input_file = "test.pov";
    options.input_text = "#version 3.7; #declare A=array[1000000]; #declare A[0]=" + value + "; #declare I=1; #while (I < 1000000)"
                         " #declare A[I]=A[I-1]; #declare I=I+1; #end #debug \"filled\\n\"";
    EXPECT_TRUE(parse_scene(options).ok);
    return static_cast<double>(after) - static_cast<double>(before);
  };
  EXPECT_LT(growth("2"), 16e6);
  EXPECT_LT(growth("<1,2,3>"), 32e6);
}

TEST(Spline, FollowsTheChapter) {
  const std::string points = " 0,<0,0,0> 1,<1,2,3> 2,<3,1,0> 4,<0,1,1> ";
  const auto at = [&](const std::string& kind, const std::string& extra, const std::string& t) {
    return printed("#declare S=spline{" + kind + points + extra + "} #debug concat(vstr(3,S(" + t + "),\",\",0,6),\"\\n\")");
  };
  EXPECT_EQ(at("quadratic_spline", "", ".25"), "0.156250,0.781250,1.312500\n");
  EXPECT_EQ(at("quadratic_spline", "", "3"), "2.666667,0.666667,-0.666667\n");
  EXPECT_EQ(at("natural_spline", "", "1.5"), "2.089674,1.695652,1.817935\n");
  EXPECT_EQ(at("cubic_spline", "5,<0,0,2>", "1.5"), "2.156250,1.625000,1.656250\n");
  EXPECT_EQ(values("#declare S=spline{linear_spline 0,0 1,<1,1,1> 1,<9,9,9>} P(S(1).x)"), "1.000000\n");
  EXPECT_EQ(printed("#declare S=spline{0,<5,6,7> 1,1} #debug concat(vstr(3,S(1),\",\",0,0),\"\\n\")"), "1,1,7\n");
}

TEST(Clock, IsSinglePrecision) {
  ParseOptions options;
  options.clock = 0.1;
  options.declares = {{"AA", "1.23456789"}};
  EXPECT_EQ(read_text("#debug concat(str(clock,0,12),\" \",str(AA,0,12),\"\\n\")", options).printed,
            "0.100000001490 1.234570000000\n");
}

class UserFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("lute_user_files_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  std::string content(const std::string& name) const { return file_text(path(name)); }

 private:
  std::filesystem::path folder_;
};

TEST_F(UserFiles, WriteNumbersWithSixDigits) {
  const Reading reading = read_text("#fopen W \"" + path("a") + "\" write #write(W,1,\",\",1/3,\",\",1e10,\",\",123456789,\",\",1e-7)" +
                                    "#write(W,<1,2,3>,\"e\") #fclose W #fopen B \"" + path("b") + "\" write " +
                                    "#write(B,uint8 65, 66 300 -5, sint16be 258, uint16le 258, sint32be -2) #fclose B");
  EXPECT_TRUE(reading.ok) << reading.error();
  EXPECT_EQ(content("a"), "1,0.333333,1e+10,1.23457e+08,1e-07<1,2,3> e");
  EXPECT_EQ(content("b"), std::string("A66295\x01\x02\x02\x01\xff\xff\xff\xfe"));
}

TEST_F(UserFiles, ReadLosesItemsWithoutComma) {
  write("blank", "7 8");
  write("comma", "7,8");
  const std::string loop = " read #while(defined(R)) #read(R,Z) P(Z) #end ";
  EXPECT_EQ(values("#fopen R \"" + path("blank") + "\"" + loop), "7.000000\n7.000000\n");
  EXPECT_EQ(values("#fopen R \"" + path("comma") + "\"" + loop), "7.000000\n8.000000\n");
}

TEST_F(UserFiles, ReadGoesToElementsThatHaveAValue) {
  write("numbers", "7,8");
  const std::string open = " #fopen R \"" + path("numbers") + "\" read ";
  EXPECT_EQ(values("#declare A=array[2]{1,2}" + open + "#read(R,A[0],A[1]) P(A[0]+A[1])"), "15.000000\n");
  EXPECT_EQ(error_of("#declare A=array[2]" + open + "#read(R,A[0])"), "Expected 'undeclared identifier', empty array found instead");
}

// The reference's binary.
TEST_F(UserFiles, KeepTheirNameUntilTheyAreClosedOrUndefined) {
  write("numbers", "7,8");
  const std::string open = "#fopen R \"" + path("numbers") + "\" read ";
  for (const char* again : {"#declare R=1;", "#declare R=\"a\"", "#macro M() #local R=1; #end M()", "#for (R,1,2) #end", "#macro R() #end"}) {
    EXPECT_EQ(error_of(open + again), "Expected 'undeclared identifier', file identifier found instead") << again;
  }
  EXPECT_EQ(error_of(open + "#declare S=R;"), "Expected 'RValue to declare', file identifier found instead");
  EXPECT_EQ(error_of(open + "#macro M(F) #read(F,A) #end M(R)"), "Expected 1 parameters but only 0 found.");
  EXPECT_EQ(values(open + "#macro M() #read(R,A) #end M() P(A) #fclose R #declare R=2; P(R)"), "7.000000\n2.000000\n");
  EXPECT_EQ(values(open + "#undef R #declare R=2; P(R)"), "2.000000\n");
}

// The reference's binary looks for the comma behind an item before it goes on, and finds what cannot be read.
TEST_F(UserFiles, ReadRefusesAStringWithoutItsEnd) {
  write("unclosed", "1,\"abc\n2,3");
  const std::string open = "#fopen R \"" + path("unclosed") + "\" read ";
  EXPECT_EQ(error_of(open + "#read(R,A,B)"), "No end quote for string.");
  EXPECT_EQ(values(open + "#read(R,A) P(A)"), "1.000000\n");
}

// The reference's binary: hundredths are rounded as int(100 v + 0.5).
TEST(Version, MayBeNegative) {
  EXPECT_EQ(values("#version -1; #declare V=version; #version 3.7; P(V)"), "-0.990000\n");
  EXPECT_EQ(values("#version -3.7; #declare V=version; #version 3.7; P(V)"), "-3.690000\n");
  EXPECT_EQ(values("#version 0.5; #declare V=version; #version 3.7; P(V)"), "0.500000\n");
}

TEST_F(UserFiles, IncludePrefersTheNameWithItsExtension) {
  write("zz", "#debug \"bare\\n\"");
  write("zz.inc", "#debug \"inc\\n\"");
  write("zz.txt", "#debug \"txt\\n\"");
  write("zz.txt.inc", "#local L=1; #declare G=2; #debug \"txt.inc\\n\"");
  EXPECT_EQ(printed("#include \"" + path("zz") + "\""), "inc\n");
  EXPECT_EQ(printed("#include \"" + path("zz.txt") + "\" #ifdef(L) #error \"local\" #end #debug concat(str(G,0,0),\"\\n\")"),
            "txt.inc\n2\n");
}

TEST_F(UserFiles, IncludeFindsTheSceneFolderAndOtherCaseLast) {
  write("Part.inc", "#debug \"part\\n\"");
  write("scene.pov", "#version 3.7; #include \"part.inc\"");
  ParseOptions options;
  std::string text;
  options.input_file = path("scene.pov");
  options.on_debug = [&](std::string_view line) { text += line; };
  const ParseResult result = parse_scene(options);
  EXPECT_TRUE(result.ok);
  EXPECT_EQ(text, "part\n");
  ASSERT_FALSE(result.diagnostics.empty());
  EXPECT_EQ(result.diagnostics.front().code, "file-case");
}

TEST(StandardIncludes, AreRead) {
  const std::string folder = "/usr/share/povray-3.7/include";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "povray-includes is not installed";
  for (const char* name : {"colors", "consts", "math", "shapes", "transforms", "rand", "strings", "finish", "functions"}) {
    ParseOptions options;
    options.library_paths = {folder};
    class Constant final : public Function {
     public:
      explicit Constant(int results) : Function(3, results) {}
      void evaluate(const double*, double* results) const override { std::fill_n(results, result_count(), 0.0); }
    };
    class Textures final : public TextureFunctions {
     public:
      FunctionPtr pigment_function(const PigmentPtr&, int) override { return std::make_shared<Constant>(5); }
      FunctionPtr pattern_function(const PatternBody&, int) override { return std::make_shared<Constant>(1); }
    } textures;
    options.texture_functions = &textures;
    const Reading reading = read_text("#include \"" + std::string(name) + ".inc\"", options);
    EXPECT_TRUE(reading.ok) << name << ": " << reading.error();
  }
}

}  // namespace
}  // namespace lute::test
