// What a scene has that says next to nothing.
#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 }
light_source { 0, rgb 1 }
