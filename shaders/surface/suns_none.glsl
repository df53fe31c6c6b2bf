// Part "suns": the light of suns that stand apart from the environment's map (formula/sun.glsl).
//   const bool kHasSuns
//   struct SunsSeen                                  how much of each is seen from a place
//   SunsSeen sunsSeen(vec3 place, vec3 up)           up: unit, of the surface there
//   SunsSeen allSuns()                               from where nothing hides them
//   void meetSuns(SurfacePoint point)                finds those of the point that is drawn: suns_at_point; and
//                                                    suns_on_mesh, which its own relief does not hide
//   vec3 lightOfSuns(Surface s, SurfacePoint point)  what a surface at that point sends of their light to the eye
//   vec3 litBySuns(Surface s, vec3 ray, SunsSeen seen, float footprint)       the same of any surface that a ray meets
//   vec3 irradianceOfSuns(vec3 n, SunsSeen seen)     on a surface with the normal n, divided by π
//   vec3 sunsAlong(vec3 origin, vec3 d, float perceptual_roughness, float footprint)      as incomingLight's
// Here: there are none.

const bool kHasSuns = false;

struct SunsSeen {
  float share;
};

const SunsSeen suns_at_point = SunsSeen(1.0);
const SunsSeen suns_on_mesh = SunsSeen(1.0);

SunsSeen sunsSeen(vec3 place, vec3 up) { return suns_at_point; }
SunsSeen allSuns() { return suns_at_point; }
void meetSuns(SurfacePoint point) {}
vec3 lightOfSuns(Surface s, SurfacePoint point) { return vec3(0.0); }
vec3 litBySuns(Surface s, vec3 ray, SunsSeen seen, float footprint) { return vec3(0.0); }
vec3 irradianceOfSuns(vec3 n, SunsSeen seen) { return vec3(0.0); }
vec3 sunsAlong(vec3 origin, vec3 d, float perceptual_roughness, float footprint) { return vec3(0.0); }
