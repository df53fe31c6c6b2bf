// Part "alpha": what opacity does.
//   bool isCutAway(float alpha)
//   vec4 shownAs(vec3 light, float alpha)      the fragment, premultiplied
// Here: nothing.

bool isCutAway(float alpha) { return false; }

vec4 shownAs(vec3 light, float alpha) { return vec4(light, 1.0); }
