# Writes OUT, a header with the commit of SOURCE_DIR, if that has changed: cmake -DSOURCE_DIR= -DOUT= -P commit_header.cmake
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --exclude=* --abbrev=12
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit unknown)  # an archive without its history
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#define ROOMCAST_COMMIT \"${commit}\"\n")
