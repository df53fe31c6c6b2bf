#pragma once

// OpenGL's functions and the names of its constants, here alone (tests/house): libepoxy's, which has those of OpenGL
// and OpenGL ES side by side, and of browsers Emscripten's OpenGL ES 3.0, which is WebGL 2.
#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
// gl2ext.h needs what gl3.h declares.
#include <GLES2/gl2ext.h>
// Of OpenGL alone: code names them, and never comes there.
#define GL_TEXTURE_CUBE_MAP_SEAMLESS 0x884F
#define GL_FRAMEBUFFER_SRGB 0x8DB9
#define GL_TIMESTAMP 0x8E28
inline void glQueryCounter(GLuint, GLenum) {}
inline void glGetQueryObjectui64v(GLuint, GLenum, GLuint64*) {}
#else
#include <epoxy/gl.h>
#endif
