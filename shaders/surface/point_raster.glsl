// Part "point": where the ray from the eye meets the surface.
//   SurfacePoint surfacePoint()
//   SurfaceChange surfaceChange()                               of the mesh there
//   void setDepth(SurfacePoint point)                           where that is not where the triangle is
//   float lightThatArrives(SurfacePoint point, vec3 towards)    the share that relief does not block
//   vec3 placeAboveRelief(SurfacePoint point, vec3 towards)     where light from there meets the mesh
//   bool seesFront()                                            whether the eye is outside
//   float iorAroundVertices()                                   of the body that the mesh lies in there; 1: not known
// Here: where the triangle was drawn.
#include "raster_point.glsl"

SurfacePoint surfacePoint() { return rasterPoint(); }

SurfaceChange surfaceChange() { return rasterChange(); }

void setDepth(SurfacePoint point) {}

float lightThatArrives(SurfacePoint point, vec3 towards) { return 1.0; }

vec3 placeAboveRelief(SurfacePoint point, vec3 towards) { return point.position; }

bool seesFront() { return gl_FrontFacing; }
