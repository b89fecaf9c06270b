# Stamps version and git state into generated/app/provenance_stamp.hpp.
#
#   include(provenance.cmake)
#   shellback_stamp(TARGET)     TARGET sees "app/provenance_stamp.hpp", fresh at each build
#
# Run as a script (cmake -P) it writes the header; the file is touched only if it changes.
if(CMAKE_SCRIPT_MODE_FILE)
  set(SHELLBACK_STAMP_GIT "unknown")
  find_package(Git QUIET)
  if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty --abbrev=12
      WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE described RESULT_VARIABLE failed
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed)
      set(SHELLBACK_STAMP_GIT "${described}")
    endif()
  endif()
  set(SHELLBACK_STAMP_VERSION "${VERSION}")
  configure_file(${SOURCE_DIR}/app/provenance.hpp.in ${OUTPUT} @ONLY)
else()
  set(SHELLBACK_STAMP_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(shellback_stamp target)
    set(generated ${CMAKE_BINARY_DIR}/generated)
    set(command ${CMAKE_COMMAND} -DSOURCE_DIR=${CMAKE_SOURCE_DIR}
      -DVERSION=${PROJECT_VERSION} -DOUTPUT=${generated}/app/provenance_stamp.hpp
      -P ${SHELLBACK_STAMP_SCRIPT})
    execute_process(COMMAND ${command})
    add_custom_target(${target}_stamp COMMAND ${command}
      BYPRODUCTS ${generated}/app/provenance_stamp.hpp COMMENT "Stamping version and git state")
    add_dependencies(${target} ${target}_stamp)
    target_include_directories(${target} PRIVATE ${generated})
  endfunction()
endif()
