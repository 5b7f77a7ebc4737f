# Makes C++ of shader files: one struct per file (blend/mix.vert -> shaders::mix_vert) with the file's text and a
# constant for each variable that has a layout, typed as in gl/shader_program.h.
#   cmake -DHEADER=generated/roomcast/render/gl/shaders.h -DSOURCE=shaders.cpp -DINCLUDE=roomcast/render/gl/shaders.h
#         "-DSHADERS=a.vert;b.frag" -DNAMESPACE=roomcast::render::shaders -P embed_shaders.cmake
# Reads declarations of one variable, on one line; stops at any other line with a layout, a uniform or a buffer.
set(structs "")
set(texts "")
set(visits "")
set(number "([0-9]+)")
set(word "([A-Za-z0-9_]+)")
foreach(shader IN LISTS SHADERS)
  get_filename_component(name "${shader}" NAME)
  string(REPLACE "." "_" name "${name}")
  file(READ "${shader}" text)

  string(REGEX REPLACE "//[^\n]*" "" lines "${text}")
  string(REPLACE ";" "" lines "${lines}")
  string(REGEX MATCHALL "[^\n]*(layout|uniform |buffer )[^\n{]*" lines "${lines}")
  list(TRANSFORM lines STRIP)
  list(FILTER lines EXCLUDE REGEX "^layout\\([^)]*\\) out ")
  # Spells out what GLSL lets one leave out.
  list(TRANSFORM lines REPLACE "\\) uniform (u?image)" ") readwrite uniform \\1")
  list(TRANSFORM lines REPLACE "local_size_x = ${number}\\)" "local_size_x = \\1, local_size_y = 1)")

  list(TRANSFORM lines REPLACE "^layout\\(location = ${number}\\) uniform ${word} ${word}$" "Uniform<${name}, \\2> \\3{\\1}")
  list(TRANSFORM lines REPLACE "^layout\\(location = ${number}\\) uniform ${word} ${word}\\[${number}\\]$"
       "Uniform<${name}, std::array<\\2, \\4>> \\3{\\1}")
  list(TRANSFORM lines REPLACE "^layout\\(location = ${number}\\) in ${word} ${word}$" "VertexInput<${name}, \\2> \\3{\\1}")
  list(TRANSFORM lines REPLACE "^layout\\(binding = ${number}\\) uniform (u?sampler${word}) ${word}$"
       "Sampler<${name}, \\2> \\4{\\1}")
  list(TRANSFORM lines REPLACE "^layout\\(${word}, binding = ${number}\\) ${word} uniform (u?image${word}) ${word}$"
       "ImageUnit<${name}, \\4> \\6{\\2, \\3, \\1}")
  list(TRANSFORM lines REPLACE "^layout\\(std430, binding = ${number}\\) (readonly |writeonly |)buffer ${word}$"
       "StorageBlock<${name}> \\3{\\1}")
  list(TRANSFORM lines REPLACE "^layout\\(local_size_x = ${number}, local_size_y = ${number}\\) in$"
       "std::array<int, 2> local_size{\\1, \\2}")

  set(members "")
  set(member_visits "")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^[a-zA-Z:]+<[^=]*> ${word}{[^{}]*}$")
      message(FATAL_ERROR "${shader}: cannot read '${line}': declare one variable with a location or binding per line")
    endif()
    string(APPEND members "  static constexpr ${line};\n")
    string(APPEND member_visits " visitor(\"${CMAKE_MATCH_1}\", ${CMAKE_MATCH_1});")
  endforeach()
  string(APPEND structs "struct ${name} {\n  static const std::string_view text;\n${members}"
         "  static void visit([[maybe_unused]] auto&& visitor) {${member_visits} }\n};\n\n")
  string(APPEND texts "const std::string_view ${name}::text = R\"glsl(${text})glsl\";\n\n")
  string(APPEND visits "  visitor(${name}{});\n")
endforeach()

# file(CONFIGURE) leaves files alone that would stay the same: who changes a shader's code recompiles no user.
file(CONFIGURE OUTPUT "${HEADER}" @ONLY CONTENT "// Made of shader files by embed_shaders.cmake; do not edit.
#pragma once
#include \"roomcast/render/gl/shader_program.h\"

namespace ${NAMESPACE} {
using namespace roomcast::render::glsl;

${structs}/// Calls `visitor` with every struct above. Each of them calls its visitor with its constants.
void visit_all(auto&& visitor) {
${visits}}

}  // namespace ${NAMESPACE}
")
file(CONFIGURE OUTPUT "${SOURCE}" @ONLY CONTENT "// Made of shader files by embed_shaders.cmake; do not edit.
#include \"${INCLUDE}\"

namespace ${NAMESPACE} {

${texts}}  // namespace ${NAMESPACE}
")
