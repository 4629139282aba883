// The debug stream: chapter 10 §6.4. Text behind the last newline is never shown; long texts are cut.
#version 3.7; global_settings { assumed_gamma 1 }
#debug "one line\n"
#debug "two" #debug " parts\n"
#debug concat(str(1/3,0,6), " ", vstr(3,<1,2,3>,",",0,2), "\n")
#debug "a\nb\n" #debug "tab\tin it\n" #debug "\n" #debug "blank before\n"
#debug "never shown"
