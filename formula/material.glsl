// The numbers of a material. Each field but Sellmeier's terms is also a row of the table in
// scene/material/material_table.cpp, which says its unit, range, meaning and glTF's name for it; this struct is what
// C++, the uniform block and the shaders hold of it.
// INITIALLY(x) is the field's default in C++, and nothing in GLSL, which has none.

const int kFresnelExact = 0;
const int kFresnelSchlick = 1;
const int kFresnelEmpirical = 2;
const int kFresnelF82 = 3;

struct Material {
  vec3 base_color INITIALLY(vec3(0.8f));        // linear: diffuse albedo, or a metal's reflectance at normal incidence
  float opacity INITIALLY(1.0f);
  float metallic INITIALLY(0.0f);
  float perceptual_roughness INITIALLY(0.5f);
  float specular INITIALLY(1.0f);               // strength of a dielectric's reflection
  vec3 specular_color INITIALLY(vec3(1.0f));    // factor on it at normal incidence
  float ior INITIALLY(1.5f);                    // index of the inside over the outside, at 588 nm
  float dispersion INITIALLY(0.0f);             // 20 / Abbe number
  vec4 sellmeier_b INITIALLY(vec4(0.0f));       // a measured substance's, whose dispersion is above 0: RefractiveIndex
  vec4 sellmeier_c INITIALLY(vec4(0.0f));
  float transmission INITIALLY(0.0f);           // share of the light which is not reflected that is refracted
  vec3 attenuation_color INITIALLY(vec3(1.0f)); // what is left of white light after attenuation_distance in the body
  float attenuation_distance INITIALLY(0.0f);   // in world units; 0: nothing is absorbed
  vec3 conductor_n INITIALLY(vec3(0.0f));       // complex index n + ik of a metal; all 0: from base_color
  vec3 conductor_k INITIALLY(vec3(0.0f));
  vec3 emission INITIALLY(vec3(0.0f));          // radiance
  int fresnel INITIALLY(kFresnelExact);
  float fresnel_offset INITIALLY(0.0f);         // of the empirical form: offset + scale · (1 + V·N)^power
  float fresnel_scale INITIALLY(1.0f);
  float fresnel_power INITIALLY(5.0f);
  vec3 f82_tint INITIALLY(vec3(1.0f));          // of the form F82: what is left of Schlick's at 82 degrees
  float height_scale INITIALLY(0.01f);          // in model units: between heights of 0 and 1
  float height_frequency INITIALLY(12.0f);      // pits of an orange a model unit; else tiles a unit of uv
  float clearcoat INITIALLY(0.0f);              // share of the surface that a clear coat of index 1.5 covers
  float clearcoat_roughness INITIALLY(0.0f);    // perceptual
  float clearcoat_normal_scale INITIALLY(1.0f); // strength of its normal map
  float clearcoat_normal_zero INITIALLY(127.5f);// as normal_zero, of that map
  vec3 sheen_color INITIALLY(vec3(0.0f));       // reflectance of the fibres of cloth that lie on the surface
  float sheen_roughness INITIALLY(0.0f);        // perceptual
  float anisotropy INITIALLY(0.0f);             // how much rougher it is along its tangent than across it
  float anisotropy_rotation INITIALLY(0.0f);    // rad, from the tangent towards the bitangent
  float iridescence INITIALLY(0.0f);            // share of the surface that a thin film covers
  float iridescence_ior INITIALLY(1.3f);        // of the film
  float iridescence_thickness_minimum INITIALLY(100.0f);  // nm, where its map is 0
  float iridescence_thickness INITIALLY(400.0f);          // nm, where its map is 1, or without one
  float alpha_cutoff INITIALLY(0.5f);
  float normal_scale INITIALLY(1.0f);           // strength of the normal map
  float normal_zero INITIALLY(127.5f);          // of 255: what stands for 0 in the normal map (decodedNormal)
  float derivative_scale INITIALLY(1.0f);       // strength of the map of slopes
  float occlusion_strength INITIALLY(1.0f);     // of the occlusion map
};
