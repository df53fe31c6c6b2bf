// Part "arriving light": the light that reaches a point.
//   vec3 incomingLight(vec3 origin, vec3 d, float perceptual_roughness, float footprint)
//                                       radiance from the direction d, blurred for the roughness;
//                                       footprint: the solid angle that one sample of a pixel sees, in sr; 0: any
//   vec3 lightOfLobe(vec3 origin, vec3 d, float perceptual_roughness, float footprint)
//                                       the same by a lobe of the surface's own reflection
//   vec3 lightOfWideLobe(vec3 origin, vec3 d, float perceptual_roughness)      for any footprint; a lobe narrower than
//                                       that of the first prefiltered level is read as that, where there are levels
//   vec3 arrivingIrradiance(vec3 origin, vec3 n)      on a surface with the normal n, divided by π
// Suns that stand apart are none of this light: the part "suns" has theirs.
// Here: an environment in cube maps.

uniform samplerCube environment;
uniform samplerCube prefiltered;
uniform samplerCube irradiance;

#include "distant_light.glsl"
