#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/image/image.h"
#include "parity/parity_case.h"

namespace mirrorball::parity {

/// The results of a GLSL expression on the GPU, one texel an input. A current context is needed.
///
/// before       what stands before main: #include lines, uniforms and functions
/// expression   of type vec4, over p, q and r
/// name         for messages
/// set          sets uniforms; textures that they name lie in units from 1 on
Result<Image> evaluate(gl::Api api, const std::string& before, const std::string& expression, const std::string& name,
                       const std::vector<Input>& inputs, const std::function<void(gl::Program&)>& set = {});

/// Whether glslang, the reference compiler, is installed; and why a test is skipped where it is not.
bool hasGlslang();
inline constexpr const char* kNoGlslang = "glslangValidator is not installed (Debian's package glslang-tools)";

/// A shader as a file.
struct GlslFile {
  std::string name;  ///< whose extension says which kind of shader it is
  std::string text;
};

/// Expects that glslang takes these shaders. Some dozens go through one process: to start one takes ten times as long
/// as a shader.
///
/// files   of different names
/// api     for the message
void expectGlslangTakes(const std::vector<GlslFile>& files, gl::Api api);

}  // namespace mirrorball::parity
