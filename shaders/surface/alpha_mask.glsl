// Part "alpha" (alpha_opaque.glsl). Here: what is below the material's threshold is not there.

bool isCutAway(float alpha) { return alpha < material.alpha_cutoff; }

vec4 shownAs(vec3 light, float alpha) { return vec4(light, 1.0); }
