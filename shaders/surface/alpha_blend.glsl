// Part "alpha" (alpha_opaque.glsl). Here: what is behind shines through.

bool isCutAway(float alpha) { return false; }

vec4 shownAs(vec3 light, float alpha) { return vec4(light * alpha, alpha); }
