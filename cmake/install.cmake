# What `cmake --install` gives to C++ programs: headers, libraries, find_package(Shellback).
#
# Installed are the libraries that solve; those of the program (app, validation, program) are its own.
include(CMakePackageConfigHelpers)
set(SHELLBACK_INSTALLED core rheology fluid thermal solid bearing film heat steady over_time judge fidelity study words)
set(package_folder lib/cmake/Shellback)

# All of them under one name.
add_library(shellback_shellback INTERFACE)
add_library(shellback::shellback ALIAS shellback_shellback)
set_target_properties(shellback_shellback PROPERTIES EXPORT_NAME shellback)
target_link_libraries(shellback_shellback INTERFACE shellback_study shellback_words shellback_fidelity)

foreach(folder IN LISTS SHELLBACK_INSTALLED)
  install(TARGETS shellback_${folder} EXPORT ShellbackTargets
    ARCHIVE DESTINATION lib COMPONENT library)
endforeach()
foreach(folder core rheology fluid thermal solid bearing fidelity)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION include/shellback
    COMPONENT library FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/app/study ${PROJECT_SOURCE_DIR}/app/words
  DESTINATION include/shellback/app
  COMPONENT library FILES_MATCHING PATTERN "*.hpp")
install(TARGETS shellback_shellback EXPORT ShellbackTargets COMPONENT library)
install(EXPORT ShellbackTargets NAMESPACE shellback:: DESTINATION ${package_folder}
  COMPONENT library)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/ShellbackConfig.cmake.in
  ${PROJECT_BINARY_DIR}/ShellbackConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ShellbackConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ShellbackConfig.cmake
  ${PROJECT_BINARY_DIR}/ShellbackConfigVersion.cmake DESTINATION ${package_folder}
  COMPONENT library)
