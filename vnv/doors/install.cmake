# What `cmake --install BUILD --prefix PREFIX` copies and cpack packs: the programs in the order of a build folder with the data that
# they read, so that they find each other wherever they lie, and what it takes to judge a solver of one's own.
#
#   bin/vnv -> lib/touchstone/vnv/vnv      lib/touchstone/reports, lib/touchstone/data
#   share/touchstone/{client,python,examples,IS_MY_SOLVER_RIGHT.md,README.md,LICENSE,LICENSE-MIT}
#   share/man/man1/vnv.1, share/{bash-completion/completions/vnv,zsh/vendor-completions/_vnv}, made of the help texts
#   include/touchstone -> share/touchstone/client/touchstone      share/cmake/Touchstone: find_package(Touchstone)
install(TARGETS vnv_command DESTINATION lib/touchstone/vnv)
install(TARGETS touchstone_report DESTINATION lib/touchstone/reports)
set(links ${PROJECT_BINARY_DIR}/links)
file(MAKE_DIRECTORY ${links})
file(CREATE_LINK ../lib/touchstone/vnv/vnv ${links}/vnv SYMBOLIC)
file(CREATE_LINK ../share/touchstone/client/touchstone ${links}/touchstone SYMBOLIC)
install(FILES ${links}/vnv DESTINATION bin)
set(texts ${PROJECT_BINARY_DIR}/vnv/texts)
install(FILES ${texts}/vnv.1 DESTINATION share/man/man1)
install(FILES ${texts}/vnv.bash DESTINATION share/bash-completion/completions RENAME vnv)
install(FILES ${texts}/vnv.zsh DESTINATION share/zsh/vendor-completions RENAME _vnv)
install(FILES ${links}/touchstone DESTINATION include)
install(DIRECTORY data/ DESTINATION lib/touchstone/data PATTERN README.md EXCLUDE PATTERN baselines EXCLUDE PATTERN claims EXCLUDE)  # the last two are of our methods

include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/TouchstoneConfigVersion.cmake COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES vnv/doors/client/TouchstoneConfig.cmake ${PROJECT_BINARY_DIR}/TouchstoneConfigVersion.cmake DESTINATION share/cmake/Touchstone)
install(DIRECTORY vnv/doors/client vnv/doors/python vnv/doors/examples DESTINATION share/touchstone PATTERN __pycache__ EXCLUDE PATTERN TouchstoneConfig.cmake EXCLUDE)
install(FILES vnv/doors/IS_MY_SOLVER_RIGHT.md vnv/doors/README.md vnv/doors/scene.schema.json vnv/doors/LICENSE-MIT LICENSE DESTINATION share/touchstone)

# build-portable/touchstone_0.2.0_amd64.deb: `cpack --config build-portable/CPackConfig.cmake`, with dpkg-dev and file.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME touchstone)
set(CPACK_PACKAGE_CONTACT "Touchstone's authors <touchstone@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gnuplot-nox, cmake, ninja-build, g++, python3-pip")
include(CPack)
