# Debian's cross-compiler for arm64 (packages: g++-12-aarch64-linux-gnu, qemu-user-static to run what comes out). The
# libraries come from a folder with Debian's arm64 packages, which scripts/arm64 makes.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc-12)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++-12)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)

if(NOT ROOMCAST_SYSROOT)
  set(ROOMCAST_SYSROOT ${CMAKE_CURRENT_LIST_DIR}/../build/arm64-root)
endif()
get_filename_component(ROOMCAST_SYSROOT ${ROOMCAST_SYSROOT} ABSOLUTE)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ROOMCAST_SYSROOT)
set(CMAKE_SYSROOT ${ROOMCAST_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)  # protoc runs here
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${ROOMCAST_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR} ${ROOMCAST_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${ROOMCAST_SYSROOT}/usr/share/pkgconfig)

# Libraries of libraries, which the linker looks up by itself.
set(libraries ${ROOMCAST_SYSROOT}/usr/lib/aarch64-linux-gnu)
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT " -Wl,-rpath-link,${libraries}:${libraries}/blas:${libraries}/lapack")
string(APPEND CMAKE_SHARED_LINKER_FLAGS_INIT " -Wl,-rpath-link,${libraries}:${libraries}/blas:${libraries}/lapack")

set(CMAKE_CROSSCOMPILING_EMULATOR
  qemu-aarch64-static;-L;${ROOMCAST_SYSROOT};-E;LD_LIBRARY_PATH=${libraries}:${libraries}/blas:${libraries}/lapack)
