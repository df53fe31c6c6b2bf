// The light that is missing in a shadow, as a share of all.
uniform vec3 missing;

out vec4 fragment;

void main() { fragment = vec4(missing, 1.0); }
