# SPDX-License-Identifier: GPL-3.0-or-later
# Headers that most files include, read once for all targets instead of once a file: a clean build
# takes a sixth less. Without it (the presets for clang and the sanitizers) it shows whether every
# file includes what it uses. Where ccache is, it does more, and does it better without.
# Not for the window: what is precompiled no longer counts as a system's header, and gcc then warns
# of Qt's own code.
option(KAMBARA_PCH "Precompile the headers that most files include" OFF)
if(KAMBARA_CCACHE)
    set(KAMBARA_PCH OFF)
endif()

set(KAMBARA_PCH_COMMON <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional>
    <sstream> <string> <string_view> <utility> <variant> <vector> <Eigen/Core> <Eigen/Geometry>)

# kambara_precompiled_set(name libraries... HEADERS <a> ...): one compilation, reused by the targets
# that are compiled with the same options.
function(kambara_precompiled_set name)
    cmake_parse_arguments(ARG "" "" "HEADERS" ${ARGN})
    if(KAMBARA_PCH AND NOT TARGET ${name})
        file(WRITE ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp "")
        add_library(${name} STATIC ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp)
        target_link_libraries(${name} PRIVATE kambara_options Eigen3::Eigen ${ARG_UNPARSED_ARGUMENTS})
        target_precompile_headers(${name} PRIVATE ${KAMBARA_PCH_COMMON} ${ARG_HEADERS})
    endif()
endfunction()

function(kambara_precompile target name)
    if(KAMBARA_PCH)
        target_precompile_headers(${target} REUSE_FROM ${name})
    endif()
endfunction()
