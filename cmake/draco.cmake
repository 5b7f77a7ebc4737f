# The target PkgConfig::DRACO, for the folder that includes this file and those below it.
find_package(PkgConfig REQUIRED)
pkg_check_modules(DRACO REQUIRED IMPORTED_TARGET draco)
# Debian 13's draco.pc names a folder relative to nothing; the headers are where compilers look anyway.
get_target_property(draco_includes PkgConfig::DRACO INTERFACE_INCLUDE_DIRECTORIES)
if(draco_includes)
  list(FILTER draco_includes INCLUDE REGEX "^/")
  set_target_properties(PkgConfig::DRACO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${draco_includes}")
endif()
