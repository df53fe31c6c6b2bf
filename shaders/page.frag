// One colour.
uniform vec4 page;

out vec4 fragment;

void main() { fragment = page; }
