# Finds single OpenCV modules. Debian's package of a single module has headers and library but no CMake configuration,
# which is in the package of all modules, several hundred megabytes larger.
#
#   roomcast_opencv_modules(core imgproc ...)      # -> opencv::core, opencv::imgproc, ...
#
# A program with the property ROOMCAST_STATIC_OPENCV takes OpenCV's archives, where these are installed: it then needs few
# packages, for Debian's shared libraries bring OpenGL and with it a compiler of shaders.

include_guard(GLOBAL)

find_library(ROOMCAST_LAPACK lapack)  # which the archives need
find_library(ROOMCAST_BLAS blas)

function(roomcast_opencv_modules)
  find_path(ROOMCAST_OPENCV_INCLUDE opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
  foreach(module IN LISTS ARGN)
    if(TARGET opencv::${module})
      continue()
    endif()
    find_library(ROOMCAST_OPENCV_${module} opencv_${module} REQUIRED)
    add_library(opencv::${module} INTERFACE IMPORTED GLOBAL)
    target_include_directories(opencv::${module} SYSTEM INTERFACE ${ROOMCAST_OPENCV_INCLUDE})
    string(REGEX REPLACE "\\.so$" ".a" archive ${ROOMCAST_OPENCV_${module}})
    if(EXISTS ${archive} AND ROOMCAST_LAPACK AND ROOMCAST_BLAS)
      set(is_static $<BOOL:$<TARGET_PROPERTY:ROOMCAST_STATIC_OPENCV>>)
      target_link_libraries(opencv::${module} INTERFACE
        $<IF:${is_static},roomcast_static_opencv,${ROOMCAST_OPENCV_${module}}>)
    else()
      target_link_libraries(opencv::${module} INTERFACE ${ROOMCAST_OPENCV_${module}})
    endif()
  endforeach()
endfunction()

# All modules that are used, in the order in which they need one another, and what they need.
add_library(roomcast_static_opencv INTERFACE)
foreach(module IN ITEMS calib3d features2d flann imgproc core)
  find_library(ROOMCAST_OPENCV_ARCHIVE_${module} libopencv_${module}.a)
  if(ROOMCAST_OPENCV_ARCHIVE_${module})
    target_link_libraries(roomcast_static_opencv INTERFACE ${ROOMCAST_OPENCV_ARCHIVE_${module}})
  endif()
endforeach()
if(ROOMCAST_LAPACK AND ROOMCAST_BLAS)
  target_link_libraries(roomcast_static_opencv INTERFACE tbb ${ROOMCAST_LAPACK} ${ROOMCAST_BLAS} z ${CMAKE_DL_LIBS})
endif()
