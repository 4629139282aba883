// libFuzzer target: the bytes as an expression where scenes have them: a value, a condition in a loop (compiled when it comes
// round), the text of a function, a colour. What it finds is kept in fuzz/corpus/scene as the scene that it made.
#include <cstddef>
#include <cstdint>

#include "fuzz/read_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read_scene("#version 3.7; #declare S = seed(1); #declare A = array[3] {1, 2, 3} #declare V = <1, 2, 3>; #declare F = function(a, b) { a+b*x }\n"
             "#declare N = " + text + ";\n#declare I = 0; #while (I < 3) #declare I = I + 1; #declare M = (" + text + ");\n#if (" + text +
             ") #end #end\n#declare G = function { " + text + " }\n#debug str(G(1, 2, 3), 0, 3)\nsphere { 0, 1 pigment { color " + text + " } }\n");
  return 0;
}
