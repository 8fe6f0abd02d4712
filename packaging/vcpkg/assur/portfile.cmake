# Builds the port from the tree that it stands in:
# vcpkg install "assur[mechanism]" --overlay-ports=packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS options FEATURES mechanism ASSUR_BUILD_MECHANISM)
if(NOT "mechanism" IN_LIST FEATURES)
  # The runtime is headers alone: nothing differs between configurations.
  set(VCPKG_BUILD_TYPE release)
endif()
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DASSUR_BUILD_GENERATOR=OFF -DASSUR_BUILD_TESTS=OFF -DASSUR_PYTHON=OFF ${options})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/assur)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
if(NOT "mechanism" IN_LIST FEATURES)
  file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib")
endif()
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
