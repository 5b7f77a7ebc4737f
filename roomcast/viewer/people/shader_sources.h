// SPDX-License-Identifier: Apache-2.0
// The text of every file in shaders/; see roomcast/render/gl/shader_sources.h.
#pragma once

#include <string_view>

namespace roomcast::viewer::shaders {

extern const std::string_view body_frag;
extern const std::string_view body_vert;
extern const std::string_view label_frag;
extern const std::string_view label_vert;

}  // namespace roomcast::viewer::shaders
