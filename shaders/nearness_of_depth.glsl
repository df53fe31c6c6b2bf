// How near what a picture shows is to the camera's place, by its depths.
uniform highp sampler2D depths;  // 1: nothing is there
uniform mat4 eye_from_texels;    // as homogeneous places
uniform float unit;              // of length

// At this pixel: 1 / distance; 0: nothing is there.
float nearnessOfDepth() {
  float depth = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).x;
  vec4 place = eye_from_texels * vec4(gl_FragCoord.xy, depth, 1.0);
  return depth < 1.0 ? unit * place.w / length(place.xyz) : 0.0;
}
