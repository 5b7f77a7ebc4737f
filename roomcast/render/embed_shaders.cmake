# Writes shader sources into a C++ file, one string_view per shader: shaders/points.vert -> shaders::points_vert.
#   cmake -DOUTPUT=shader_sources.cpp "-DSHADERS=a.vert;b.frag" -DHEADER=roomcast/render/gl/shader_sources.h -DNAMESPACE=roomcast::render::shaders -P embed_shaders.cmake
# HEADER declares the string_views, in NAMESPACE.
set(definitions "")
foreach(shader IN LISTS SHADERS)
  get_filename_component(name "${shader}" NAME)
  string(REPLACE "." "_" name "${name}")
  file(READ "${shader}" text)
  string(APPEND definitions "const std::string_view ${name} = R\"glsl(${text})glsl\";\n\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made from shader files by embed_shaders.cmake; do not edit.
#include \"${HEADER}\"

namespace ${NAMESPACE} {

${definitions}}  // namespace ${NAMESPACE}
")
