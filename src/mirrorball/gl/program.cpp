#include "mirrorball/gl/program.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "mirrorball/gl/gl_api.h"

namespace mirrorball::gl {
namespace {

void destroyShader(unsigned name) { glDeleteShader(name); }
using Shader = Handle<destroyShader>;

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

Result<Shader> compile(GLenum stage, const ShaderSource& source, const std::string& name) {
  Shader shader(glCreateShader(stage));
  const char* text = source.text.data();
  const GLint length = static_cast<GLint>(source.text.size());
  glShaderSource(shader.name(), 1, &text, &length);
  glCompileShader(shader.name());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    return fail(ErrorCode::unsupported,
                name + ": the graphics driver cannot compile this shader: " +
                    namedLog(logOf(shader.name(), glGetShaderiv, glGetShaderInfoLog), source.files));
  }
  return shader;
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

Result<Program> Program::build(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& name) {
  MIRRORBALL_TRY(vertex_shader, compile(GL_VERTEX_SHADER, vertex, name));
  MIRRORBALL_TRY(fragment_shader, compile(GL_FRAGMENT_SHADER, fragment, name));
  Program program(glCreateProgram());
  const GLuint handle = program.handle_.name();
  glAttachShader(handle, vertex_shader.name());
  glAttachShader(handle, fragment_shader.name());
  glLinkProgram(handle);
  GLint linked = GL_FALSE;
  glGetProgramiv(handle, GL_LINK_STATUS, &linked);
  if (!linked) {
    return fail(ErrorCode::unsupported, name + ": the graphics driver cannot link this shader: " +
                                            namedLog(logOf(handle, glGetProgramiv, glGetProgramInfoLog), {}));
  }
  program.declarations_ = uniformsIn(vertex.text) + uniformsIn(fragment.text);
  return program;
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

}  // namespace mirrorball::gl
