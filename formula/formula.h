#pragma once

/// Every equation of the subject, as C++: the same files that are joined into the shaders (gl/shader_source.h), read
/// through a prelude over GLM (glsl_begin.inc). How the files are written so that both sides take them is told in
/// docs/architecture.md, "Formula once". The rooms include the header of their topic, so that a formula that changes
/// compiles only what uses it.

#include "formula/bodies.h"
#include "formula/bsdf.h"
#include "formula/color.h"
#include "formula/constants.h"
#include "formula/lamp.h"
#include "formula/material.h"
#include "formula/prefilter.h"
#include "formula/projection.h"
#include "formula/proxy.h"
#include "formula/relief.h"
#include "formula/sky.h"
#include "formula/sun.h"
#include "formula/surface.h"
#include "formula/tangent.h"
