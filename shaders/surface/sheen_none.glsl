// Part "sheen": fibres of cloth on the surface.
//   void layCloth(inout Surface s, SurfacePoint point)      sets its albedo
//   vec3 lightOnCloth(Surface s, SurfacePoint point)        the mean radiance that it reflects
// Here: none.

void layCloth(inout Surface s, SurfacePoint point) { s.sheen_albedo = 0.0; }

vec3 lightOnCloth(Surface s, SurfacePoint point) { return vec3(0.0); }
