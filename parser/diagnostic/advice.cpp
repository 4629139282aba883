#include "parser/diagnostic/advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lute {

namespace {

struct Advice {
  std::string_view message;  // how the message begins
  std::string_view found;    // what was found, or "": anything
  std::string_view hint;
};

// The first row that fits counts.
constexpr Advice kAdvice[] = {
    // Statements and blocks.
    {"Expected 'object or directive'", ";", "a ';' ends #declare and #version only: leave it out"},
    {"Expected 'object or directive'", "}", "no block is open here: leave the } out, or look for a { that is missing above"},
    {"Expected 'object or directive'", "pigment", "a pigment belongs inside an object or texture, or behind #declare NAME ="},
    {"Expected 'object or directive'", "texture", "a texture belongs inside an object, or behind #declare NAME ="},
    {"Expected 'object or directive'", "finish", "a finish belongs inside an object or texture, or behind #declare NAME ="},
    {"Expected 'object or directive'", "normal", "a normal belongs inside an object or texture, or behind #declare NAME ="},
    {"Expected 'object or directive'", "interior", "an interior belongs inside an object, or behind #declare NAME ="},
    {"Expected 'object or directive'", "material", "a material belongs inside an object, or behind #declare NAME ="},
    {"Expected 'object or directive'", "if", "directives begin with #: #if(...) ... #end"},
    {"Expected 'object or directive'", "while", "directives begin with #: #while(...) ... #end"},
    {"Expected 'object or directive'", "for", "directives begin with #: #for(...) ... #end"},
    {"Expected 'object or directive'", "else", "directives begin with #: #else"},
    {"Expected 'object or directive'", "end", "directives begin with #: #end"},
    {"Expected 'object or directive'", "macro", "directives begin with #: #macro NAME(...) ... #end"},
    {"Expected 'object or directive'", "*", "put the whole expression in parentheses"},
    {"Expected 'object or directive'", "/", "put the whole expression in parentheses"},
    {"Expected 'object or directive'", "+", "put the whole expression in parentheses"},
    {"Expected 'object or directive'", "local", "directives begin with #: #local NAME = ..."},
    {"Expected 'object or directive'", "{",
     "in front of { stands a keyword: a declared object is used as object { NAME }; directives need no braces"},
    {"Expected 'object or directive'", "cube", "a cube is a box: box { <corner>, <opposite corner> }"},
    {"Expected 'object or directive'", "assumed_gamma", "it belongs inside global_settings { ... }"},
    {"Expected 'object or directive'", "translate", "it belongs inside the block of the object that it moves, in front of the }"},
    {"Expected 'object or directive'", "rotate", "it belongs inside the block of the object that it turns, in front of the }"},
    {"Expected 'object or directive'", "scale", "it belongs inside the block of the object that it scales, in front of the }"},
    {"Expected 'object or directive', undeclared", "", "nothing of this name is declared: is it misspelt, or an #include missing?"},
    {"Expected 'object or directive'", "", "nothing begins with this here: is a } too many, or a { missing, above?"},
    {"Expected 'object', undeclared", "", "declare it first: #declare NAME = sphere { ... }"},
    {"Missing { after", "", "the items of a statement stand in braces: keyword { ... }"},
    {"No matching } in 'array'", "", "the array has more items than its size"},
    {"No matching } in", ",", "no comma is allowed here, or the item behind it does not belong in this block"},
    {"No matching } in", ";", "items of a block are not ended with ';'"},
    {"No matching } in", "End of File", "a } is missing"},
    {"No matching } in 'camera'", "<", "camera { location <x, y, z> look_at <x, y, z> }"},
    {"No matching } in 'pigment'", "<", "a colour begins with rgb: pigment { rgb <r, g, b> }"},
    {"No matching } in 'pigment'", "gradient", "the pattern stands first: pigment { gradient x color_map { ... } }"},
    {"No matching } in 'global_settings'", "ambient", "the light everywhere is set by ambient_light"},
    {"No matching } in", "rgb", "a colour stands inside pigment { ... }"},
    {"No matching } in", "color", "a colour stands inside pigment { ... }"},
    {"No matching } in", "colour", "a colour stands inside pigment { ... }"},
    {"No matching } in", "-", "objects stand one behind the other, without signs"},
    {"No matching } in", "", "in front of this a } is missing, or it does not belong in the block"},
    {"All #declares of float", "", "write ';' behind the value"},
    {"Expected 'RValue to declare'", "", "a number, vector, colour, string, or a statement such as sphere { ... } can be declared"},
    {"Expected 'undeclared identifier', macro identifier", "", "a macro of this name exists: #undef it first, or use another name"},
    {"Expected 'undeclared identifier', undeclared", "", ""},
    {"Expected 'undeclared identifier', empty array", "", "give the element a value first: #declare A[i] = ..."},
    {"Expected 'undeclared identifier'", "", "this name is taken: choose another one, for example with a capital letter"},
    {"Expected 'parameter identifier'", "", "parameters are names that are not reserved words, separated by commas"},
    {"Cannot assign uninitialized identifier", "", "declare it first: #declare NAME = ..."},
    {"Cannot pass uninitialized identifier", "", "declare it first: #declare NAME = ..."},

    // Expressions.
    {"Expected 'numeric expression'", "=", "a comparison is written with one =, and inside parentheses"},
    {"Expected 'numeric expression'", "&", "'and' is written with one &"},
    {"Expected 'numeric expression'", "|", "'or' is written with one |"},
    {"Expected 'numeric expression'", "sqr", "write x*x: sqr works in no expression"},
    {"Expected 'numeric expression'", "rgb", "colour keywords are no operands: declare the colour and use its name"},
    {"Expected 'numeric expression'", "}", "a value is missing in front of the }"},
    {"Expected 'numeric expression'", ",", "a value is missing in front of the comma"},
    {"Expected 'numeric expression'", ";", "a value is missing in front of the ';'"},
    {"Expected 'numeric expression'", ")", "a value is missing in front of the )"},
    {"Expected 'numeric expression', undeclared", "", "declare it first: #declare NAME = VALUE;"},
    {"Expected 'numeric expression'", "", "a number or a vector is missing in front of this"},
    {"Expected 'string expression'", "'", "strings stand in double quotes: \"...\""},
    {"Expected 'string expression', float", "", "a number becomes a string by str(VALUE, 0, -1)"},
    {"Expected 'string expression'", "", "a text in double quotes belongs here: \"...\""},
    {"Expected 'string comparison operator'", "", "a number belongs here, not a string"},
    {"Expected '('", "", "conditions and arguments stand in parentheses: #if (A = B), NAME(A, B)"},
    {"Expected '=', + found", "", "a variable is counted up by #declare I = I + 1;"},
    {"Expected '>'", ",", "a vector has at most five components"},
    {"Expected '>'", ">=", "write a blank between > and ="},
    {"Expected '>'", "*", "in a #version below 1.5 operators stand in parentheses only: (a * b)"},
    {"Expected '>'", "/", "in a #version below 1.5 operators stand in parentheses only: (a / b)"},
    {"Expected '>'", "", "the vector ends with >"},
    {"Float expected but vector", "", "a single number belongs here: take a component, as in V.x or C.red, or vlength(V)"},
    {"UV_Vector expected", "", "a vector <u, v> of two components belongs here"},
    {"Vector expected but color", "", "a vector <x, y, z> of three components belongs here"},
    {"Conditional must evaluate to a float", "", "take a component of the vector, as in (V.x ? a : b)"},
    {"Bad operands for period operator", "", "the value has fewer components"},
    {"Expected 'x, y, z or color component'", "", "components are x y z t u v, red green blue filter transmit and gray"},
    {"Illegal random number generator", "", "make one first: #declare R = seed(1); then rand(R)"},
    {"Object identifier expected", "", "declare the object and use its name"},
    {"Solid object identifier expected", "", "triangles, meshes, patches, discs and polygons have no inside"},
    {"The expression is nested too deeply", "", "declare parts of it; --max-nesting N allows more"},
    {"Objects are nested too deeply", "", "--max-depth N allows more"},
    {"Pigments are nested too deeply", "", "--max-depth N allows more"},
    {"Normals are nested too deeply", "", "--max-depth N allows more"},
    {"Textures are nested too deeply", "", "--max-depth N allows more"},
    {"Functions call each other too deeply", "", "--max-depth N allows more"},
    {"Too many loop turns", "", "does the loop end? --max-loop-turns N allows more"},
    {"Too many tokens", "", "do the loops and macros end? --max-tokens N allows more"},
    {"The scene needs more memory than there is", "", "smaller arrays, meshes and images, or fewer objects, need less"},
    {"The scene needs more memory", "", "--max-memory MB allows more"},
    {"Illegal parameters in substr", "", "substr(TEXT, P, N) needs 1 <= P and P + N - 1 <= strlen(TEXT)"},

    // Text.
    {"String too long", "", "names and strings have at most 255 characters: join strings with concat(...)"},
    {"No end quote for string", "", "write \" at its end; inside a string \\\" is a quote"},
    {"Unterminated string literal", "", "a backslash may not stand at the end of a line"},
    {"No */ closing comment found", "", "comments nest: each /* needs a */ of its own"},
    {"Illegal escape sequence", "", "a backslash is written \\\\ in strings"},
    {"Unexpected end of escape sequence", "", "\\u is followed by four hexadecimal digits"},
    {"Illegal character in input file", "", "outside of strings and comments a scene is plain ASCII"},
    {"Unexpected additional '.'", "", "a number has one decimal point"},

    // Arrays.
    {"Negative subscript", "", "elements are counted from 0"},
    {"Recursive function calls", "", "a macro may call itself, a function may not"},
    {"Attempt to access uninitialized array element", "", "assign it first: #declare A[i] = ..."},
    {"Attempted to redefine", "", "all elements of an array have the type of the first that was assigned"},
    {"An array declaration must", "", "its size stands in brackets: array[3], or array[3] { 1, 2, 3 }"},
    {"Invalid dimension size", "", "sizes are at least 1: array[N]"},
    {"Too many array dimensions", "", "an array has at most 5"},

    // Conditionals, loops, macros, files.
    {"Mis-matched '#end'", "", "no #if, #while, #for, #switch or #macro is open here"},
    {"Mis-matched '#else'", "", "no #if is open here, or it has an #else already"},
    {"Mis-matched '#elseif'", "", "no #if is open here, or it has an #else already"},
    {"Mis-matched '#case'", "", "#case and #range belong inside #switch(...) ... #end"},
    {"#switch not followed", "", "#switch(VALUE) #case(V) ... #break #range(A, B) ... #else ... #end"},
    {"Invalid context for #break", "", "#break leaves a #while, #for, #switch or macro"},
    {"#for loop increment", "", "#for(NAME, START, END, STEP)"},
    {"#for loop variable must not be", "", "use a name of its own and copy it to the element"},
    {"Too many nested symbol tables", "", "a macro calls itself without end: at most 98 calls may be open at once"},
    {"Too many nested include files", "", "a file includes itself without end: at most 32 may be open at once"},
    {"Cannot open include file", "", "name its folder with Library_Path=FOLDER or +LFOLDER"},
    {"Cannot open image file", "", "name its folder with Library_Path=FOLDER or +LFOLDER"},
    {"This platform has not defined a SYS", "", "image type sys is not supported: name the type of the file, for example png"},
    {"sum() or prod()", "", "the running variable goes from the second argument to the third in steps of 1"},
    {"Cannot open density file", "", "name its folder with Library_Path=FOLDER or +LFOLDER"},
    {"Cannot open font file", "", "name its folder with Library_Path=FOLDER or +LFOLDER"},
    {"Expected 'file identifier'", "", "open the file first: #fopen NAME \"file\" write"},

    // Statements.
    {"Cannot parse sRGB colors", "", "set it first: global_settings { assumed_gamma 1.0 }"},
    {"uv_mapping must be specified", "", "write uv_mapping in front of the texture"},
    {"Empty sky_sphere statement", "", "sky_sphere { pigment { ... } }"},
    {"Patterned texture must have", "", "texture { PATTERN texture_map { [0 ...] [1 ...] } }"},
    {"Average must have map", "", "average needs a map: pigment { average pigment_map { [1 ...] [1 ...] } }"},
    {"Cannot layer over a patterned", "", "let the textures of its map have layers instead"},
    {"Camera location and look_at", "", "move the camera: location <0, 0, -5>"},
    {"Degenerate plane normal", "", "plane { <0, 1, 0>, distance }"},
    {"Must have at least one color", "", "entries stand in brackets: [0 rgb 0] [1 rgb 1]"},
    {"Must have at least one entry", "", "entries stand in brackets: [0 ...] [1 ...]"},
    {"Quick color belongs in texture", "", "a colour stands inside pigment { ... }: pigment { color rgb 1 }"},
    {"split_union found in non-union", "", "split_union belongs inside a union"},
};

std::string_view found_text(const Diagnostic& d) {
  if (d.message.find("End of File") != std::string::npos) return "End of File";
  if (d.where.column == 0 || d.where.column > d.excerpt.size()) return "End of File";
  const std::size_t length = d.end_column > d.where.column ? d.end_column - d.where.column : 1;
  return std::string_view(d.excerpt).substr(d.where.column - 1, length);
}

}  // namespace

std::string advice(const Diagnostic& diagnostic) {
  const std::string_view found = found_text(diagnostic);
  for (const Advice& row : kAdvice) {
    if (diagnostic.message.starts_with(row.message) && (row.found.empty() || row.found == found)) return std::string(row.hint);
  }
  return "";
}

std::string index_advice(std::string_view what, std::size_t count, double index) {
  if (count == 0) return "there are none of " + std::string(what);
  char written[32];
  std::snprintf(written, sizeof written, "%.12g", std::trunc(index));
  return std::string(what) + " are counted from 0 to " + std::to_string(count - 1) + ", this is " + written;
}

}  // namespace lute
