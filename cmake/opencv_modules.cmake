# Finds single OpenCV modules. Debian's package of a single module has headers and library but no CMake configuration,
# which is in the package of all modules, several hundred megabytes larger.
#
#   roomcast_opencv_modules(core imgproc ...)      # -> opencv::core, opencv::imgproc, ...

function(roomcast_opencv_modules)
  find_path(ROOMCAST_OPENCV_INCLUDE opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
  foreach(module IN LISTS ARGN)
    if(TARGET opencv::${module})
      continue()
    endif()
    find_library(ROOMCAST_OPENCV_${module} opencv_${module} REQUIRED)
    add_library(opencv::${module} INTERFACE IMPORTED GLOBAL)
    target_include_directories(opencv::${module} SYSTEM INTERFACE ${ROOMCAST_OPENCV_INCLUDE})
    target_link_libraries(opencv::${module} INTERFACE ${ROOMCAST_OPENCV_${module}})
  endforeach()
endfunction()
