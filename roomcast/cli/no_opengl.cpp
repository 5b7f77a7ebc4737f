// SPDX-License-Identifier: Apache-2.0
// Linked into the programs for one role. OpenCV's archive looks for OpenGL by this function, for
// pictures on a graphics card, which these programs have none of. Without it they would need the
// system's OpenGL, and with it a compiler of shaders.

extern "C" {

using GlFunction = void (*)();
GlFunction glXGetProcAddressARB(const unsigned char* name);

GlFunction glXGetProcAddressARB(const unsigned char* /*name*/) {
  return nullptr;
}
}
