// The suns of a frame, in the world.
#include "sun.glsl"

// Of each: towards it, and its radius; its irradiance.
uniform vec4 sun_rows[2 * SUN_COUNT];

Sun sunAt(int index) { return Sun(sun_rows[2 * index].xyz, sun_rows[2 * index].w, sun_rows[2 * index + 1].xyz); }
