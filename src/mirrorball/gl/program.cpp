#include "mirrorball/gl/program.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/platform/platform.h"

namespace mirrorball::gl {
namespace {

constexpr GLenum kCompletionStatus = 0x91B1;  // KHR_parallel_shader_compile

/// The compiler's or linker's words: `get` is glGetShaderiv or glGetProgramiv, and so on.
template <typename GetNumber, typename GetLog>
std::string logOf(GLuint object, GetNumber get, GetLog get_log) {
  GLint length = 0;
  get(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  get_log(object, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

/// The lines of a shader that declare uniforms.
std::string uniformsIn(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    if (text.starts_with("uniform ")) lines += text.substr(0, end);
    text.remove_prefix(end);
  }
  return lines;
}

/// Whether one of those lines declares `name`, as an array or not.
[[maybe_unused]] bool declares(const std::string& lines, const std::string& name) {
  return lines.find(" " + name + ";") != std::string::npos || lines.find(" " + name + "[") != std::string::npos;
}

}  // namespace

PendingProgram::Stage PendingProgram::compile(unsigned kind, ShaderSource source) {
  Handle<destroyShader> shader(glCreateShader(kind));
  const char* text = source.text.data();
  const GLint length = static_cast<GLint>(source.text.size());
  glShaderSource(shader.name(), 1, &text, &length);
  glCompileShader(shader.name());
  return {std::move(source), std::move(shader)};
}

void PendingProgram::destroyShader(unsigned name) { glDeleteShader(name); }

PendingProgram::PendingProgram(ShaderSource vertex, ShaderSource fragment, std::string name)
    : name_(std::move(name)),
      vertex_(compile(GL_VERTEX_SHADER, std::move(vertex))),
      fragment_(compile(GL_FRAGMENT_SHADER, std::move(fragment))),
      program_(glCreateProgram()) {
  const GLuint program = program_.handle_.name();
  glAttachShader(program, vertex_.shader.name());
  glAttachShader(program, fragment_.shader.name());
  glLinkProgram(program);
}

bool PendingProgram::isReady() const {
  if (!hasExtension("GL_KHR_parallel_shader_compile")) return true;
  GLint is_complete = GL_TRUE;
  glGetProgramiv(program_.handle_.name(), kCompletionStatus, &is_complete);
  return is_complete != GL_FALSE;
}

Result<void> PendingProgram::check(const Stage& stage) const {
  GLint compiled = GL_FALSE;
  glGetShaderiv(stage.shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled) return {};
  return fail(ErrorCode::unsupported,
              name_ + ": the graphics driver cannot compile this shader: " +
                  namedLog(logOf(stage.shader.name(), glGetShaderiv, glGetShaderInfoLog), stage.source.files));
}

Result<Program> PendingProgram::finish() {
  MIRRORBALL_TRY_VOID(check(vertex_));
  MIRRORBALL_TRY_VOID(check(fragment_));
  const GLuint program = program_.handle_.name();
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) {
    return fail(ErrorCode::unsupported, name_ + ": the graphics driver cannot link this shader: " +
                                            namedLog(logOf(program, glGetProgramiv, glGetProgramInfoLog), {}));
  }
  program_.declarations_ = uniformsIn(vertex_.source.text) + uniformsIn(fragment_.source.text);
  return std::move(program_);
}

Result<Program> Program::build(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& name) {
  return PendingProgram(vertex, fragment, name).finish();
}

Result<Program> Program::load(Api api, std::string_view vertex_entry, std::string_view fragment_entry,
                              std::span<const std::string_view> defines) {
  MIRRORBALL_TRY(vertex, shaderSource(api, vertex_entry, defines));
  MIRRORBALL_TRY(fragment, shaderSource(api, fragment_entry, defines));
  return build(vertex, fragment, std::string(vertex_entry) + " with " + std::string(fragment_entry));
}

void Program::destroy(unsigned name) {
  // One that is deleted in use lives on until another is used. NVIDIA's driver (580.159) then lost the first draw of
  // the program that was given its name next.
  glUseProgram(0);
  glDeleteProgram(name);
}

std::optional<BlockLayout> Program::connect(const std::string& block, unsigned point) {
  const GLuint index = glGetUniformBlockIndex(handle_.name(), block.c_str());
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(handle_.name(), index, point);
  return BlockLayout::of(handle_.name(), block);
}

void Program::use() const { glUseProgram(handle_.name()); }

int Program::locationOf(std::string_view uniform) {
  use();
  if (const auto known = locations_.find(uniform); known != locations_.end()) return known->second;
  std::string name(uniform);
  const int location = glGetUniformLocation(handle_.name(), name.c_str());
  assert((location >= 0 || declares(declarations_, name)) && "no shader of the program declares that uniform");
  locations_.emplace(std::move(name), location);
  return location;
}

void Program::set(std::string_view uniform, float value) { glUniform1f(locationOf(uniform), value); }

void Program::set(std::string_view uniform, int value) { glUniform1i(locationOf(uniform), value); }

void Program::set(std::string_view uniform, glm::vec2 value) {
  glUniform2fv(locationOf(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, glm::vec3 value) {
  glUniform3fv(locationOf(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, glm::vec4 value) {
  glUniform4fv(locationOf(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::mat3& value) {
  glUniformMatrix3fv(locationOf(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::mat4& value) {
  glUniformMatrix4fv(locationOf(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, std::span<const glm::vec4> values) {
  glUniform4fv(locationOf(uniform), static_cast<GLsizei>(values.size()), reinterpret_cast<const float*>(values.data()));
}

void Program::set(std::string_view uniform, std::span<const glm::uvec4> values) {
  glUniform4uiv(locationOf(uniform), static_cast<GLsizei>(values.size()),
                reinterpret_cast<const GLuint*>(values.data()));
}

}  // namespace mirrorball::gl
