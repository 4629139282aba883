// a line comment
/* a block comment */ sphere /* between */ { 0, /* nested /* blocks */ end here */ 1 }
// a line that ends with a backslash \
box // to the end of the line
plane /* over
lines */ { y, 0 }cone	/**/"/* no comment */" "// nor this"
/* never ends
