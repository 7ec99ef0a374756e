# SPDX-License-Identifier: BSD-3-Clause
# A port for vcpkg. scripts/release replaces the keys between at signs by their values.
# tests/slow/recipes runs it with stubs of vcpkg's functions. It has not been built, because
# vcpkg was not available.
vcpkg_download_distfile(ARCHIVE
    URLS "@HOMEPAGE@/libstltsa-${VERSION}.tar.xz"
    FILENAME "libstltsa-${VERSION}.tar.xz"
    SHA512 @SHA512@
)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")

# LDL in place of CHOLMOD, which is partly under the GPL.
vcpkg_configure_meson(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        -Dtests=false
        -Ddocs=false
        -Dtools=false
        -Dsparse=ldl
        -Dblas=reference
)
vcpkg_install_meson()
vcpkg_fixup_pkgconfig()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/stltsa PACKAGE_NAME stltsa)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
