#pragma once

#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/shader_source.h"
#include "mirrorball/render/surface/surface_variant.h"

namespace mirrorball {

/// The two shaders of a variant.
struct SurfaceShaders {
  gl::ShaderSource vertex;
  gl::ShaderSource fragment;
};

/// errors   not_found: a part's file (a mistake in the table)
Result<SurfaceShaders> surfaceShaders(gl::Api api, const SurfaceVariant& variant);

/// A shader of shaders/ that asks for the part "proxy" alone.
///
/// errors   not_found: a part's file (a mistake in the table of parts)
Result<gl::ShaderSource> withProxy(gl::Api api, std::string_view entry, ProxyKind kind);

}  // namespace mirrorball
