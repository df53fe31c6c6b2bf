// The suns that a surface of one normal and one lobe reflects (look_up_environment.glsl).
vec3 reflectedSuns(Surface s, SurfacePoint point) { return lightOfSuns(s, point); }
