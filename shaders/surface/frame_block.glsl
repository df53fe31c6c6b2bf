// What all surfaces of a frame share.
layout(std140) uniform FrameBlock {
  mat4 clip_from_world;
  mat4 world_from_clip;
  mat4 look_up_matrix;     // of the coordinates of reflected light: to a direction of the world, or to (s, t, r, q)
  mat4 picture_matrix;     // of those of base_color_map: to (s, t, r, q)
  mat4 back_faces_from_world;  // to texels of the picture of back faces, and clip space's depth
  mat4 eye_from_back_faces;    // back, to places as seen from the camera's, in the world's axes
  mat3 eye_from_world;
  vec3 camera_position;
  float orthographic;      // 1: all rays go along camera_forward
  vec3 camera_forward;
  float screen_unit;       // world units; of the distances in the picture of opaque surfaces
  vec3 shown_low;          // the box around all that the picture of opaque surfaces shows
  vec3 shown_high;
  vec4 pixel_cell;         // of the pixel, which the sample that is drawn stands for: from its place to the cell's
                           // middle, and the cell's size (render/surface/pixel_cells.h)
  float samples_per_pixel;
  float sample_phase;      // of the sample that is drawn: (its number + ½) / samples_per_pixel
  int inner_bounces;       // surfaces that light meets after the first, where bodies are traced
  float only_wavelength;   // µm, for which each material has one index; 0: light is of all wavelengths
  int wavelength_count;    // of a set, where light is dispersed into wavelengths
  vec4 wavelengths[256];   // kWavelengthSets of them: shares in red, green and blue; µm
};
