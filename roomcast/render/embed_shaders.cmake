# Writes shader sources into a C++ file, one string_view per shader: shaders/points.vert -> shaders::points_vert.
#   cmake -DOUTPUT=shader_sources.cpp "-DSHADERS=a.vert;b.frag" -P embed_shaders.cmake
set(definitions "")
foreach(shader IN LISTS SHADERS)
  get_filename_component(name "${shader}" NAME)
  string(REPLACE "." "_" name "${name}")
  file(READ "${shader}" text)
  string(APPEND definitions "const std::string_view ${name} = R\"glsl(${text})glsl\";\n\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made from the files in roomcast/render/shaders; do not edit.
#include \"roomcast/render/shader_sources.h\"

namespace roomcast::shaders {

${definitions}}  // namespace roomcast::shaders
")
