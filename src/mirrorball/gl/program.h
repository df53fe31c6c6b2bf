#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/handle.h"
#include "mirrorball/gl/shader_source.h"
#include "mirrorball/gl/uniform_block.h"

namespace mirrorball::gl {

/// A linked vertex and fragment shader.
///
/// A uniform that no shader of it declares is a mistake, which builds with assertions stop at. One that is declared and
/// not used is ignored by set(): compilers remove what no output depends on.
class Program {
 public:
  /// Compiles and links.
  ///
  /// name     for messages
  /// errors   unsupported: the driver's own words, with file and line of each shader text
  static Result<Program> build(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& name);

  /// Joins two entry files of /shaders and builds them: `Program::load(api, "screen.vert",
  /// "background.frag", defines)`.
  ///
  /// errors   not_found (shaderSource); unsupported
  static Result<Program> load(Api api, std::string_view vertex_entry, std::string_view fragment_entry,
                              std::span<const std::string_view> defines = {});

  /// Lets a uniform block read what is bound to `point` (UniformBlock::bind).
  ///
  /// returns  where the block's members lie; nothing where the program has no such block
  std::optional<BlockLayout> connect(const std::string& block, unsigned point);

  /// What is drawn from now on goes through this program.
  void use() const;

  /// Sets a uniform, and makes this program the one in use. Samplers take the number of their
  /// texture unit.
  void set(std::string_view uniform, float value);
  void set(std::string_view uniform, int value);
  void set(std::string_view uniform, glm::vec2 value);
  void set(std::string_view uniform, glm::vec3 value);
  void set(std::string_view uniform, glm::vec4 value);
  void set(std::string_view uniform, const glm::mat3& value);
  void set(std::string_view uniform, const glm::mat4& value);
  /// An array: `uniform vec4 rows[9]` is set as "rows".
  void set(std::string_view uniform, std::span<const glm::vec4> values);
  void set(std::string_view uniform, std::span<const glm::uvec4> values);

 private:
  friend class PendingProgram;
  static void destroy(unsigned name);
  explicit Program(unsigned name) : handle_(name) {}
  int locationOf(std::string_view uniform);

  Handle<destroy> handle_;
  /// Of the uniforms asked for so far; −1 for those that the program lacks.
  std::map<std::string, int, std::less<>> locations_;
  std::string declarations_;  // the lines of its shaders that declare uniforms
};

/// A program that was given to the driver, which may make it beside others that are submitted before one of them is
/// finished (KHR_parallel_shader_compile).
class PendingProgram {
 public:
  /// name   for messages
  PendingProgram(ShaderSource vertex, ShaderSource fragment, std::string name);

  /// Whether finish() does not wait, as far as the driver says so.
  bool isReady() const;

  /// Waits for it. Can be called once.
  ///
  /// errors   as Program::build's
  Result<Program> finish();

 private:
  static void destroyShader(unsigned name);
  struct Stage {
    ShaderSource source;
    Handle<destroyShader> shader;
  };
  static Stage compile(unsigned kind, ShaderSource source);
  Result<void> check(const Stage& stage) const;

  std::string name_;
  Stage vertex_;
  Stage fragment_;
  Program program_;
};

}  // namespace mirrorball::gl
