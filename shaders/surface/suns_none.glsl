// Part "suns": the light of suns that stand apart from the environment's map (formula/sun.glsl).
//   void meetSuns(SurfacePoint point)                which of them the point sees, for lightOfSuns
//   vec3 lightOfSuns(Surface s, SurfacePoint point)  what a surface at that point sends of it to the eye
//   vec3 litBySuns(Surface s, vec3 place, vec3 ray)  the same of a surface elsewhere, which a ray meets
//   vec3 irradianceOfSuns(vec3 n)                    on a surface with the normal n that sees them all, divided by π
//   vec3 sunsAlong(vec3 origin, vec3 d, float perceptual_roughness, float footprint)      as incomingLight's
// Here: there are none.

void meetSuns(SurfacePoint point) {}
vec3 lightOfSuns(Surface s, SurfacePoint point) { return vec3(0.0); }
vec3 litBySuns(Surface s, vec3 place, vec3 ray) { return vec3(0.0); }
vec3 irradianceOfSuns(vec3 n) { return vec3(0.0); }
vec3 sunsAlong(vec3 origin, vec3 d, float perceptual_roughness, float footprint) { return vec3(0.0); }
