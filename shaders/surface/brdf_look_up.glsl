// How much of a white environment's light rough surfaces reflect, as render/surface/surface_program.cpp has made it.
#include "brdf_table.glsl"

uniform sampler2D brdf_table;
