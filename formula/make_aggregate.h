#pragma once

namespace mirrorball::formula {

/// A struct of formulas with these fields, in their order: what `MAKE(Type)(fields…)` is in C++ (glsl_begin.inc). GLSL
/// writes `Type(fields…)`, which compilers for browsers do not take for a struct without constructors.
template <typename Type, typename... Fields>
constexpr Type makeAggregate(Fields... fields) {
  return Type{fields...};
}

}  // namespace mirrorball::formula
