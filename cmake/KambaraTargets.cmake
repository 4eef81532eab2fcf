# SPDX-License-Identifier: GPL-3.0-or-later
# How every target of the project is built: language level, warnings, sanitizers, ccache.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(KAMBARA_CCACHE ccache)
if(KAMBARA_CCACHE)
    set(CMAKE_C_COMPILER_LAUNCHER ${KAMBARA_CCACHE})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${KAMBARA_CCACHE})
endif()

add_library(kambara_options INTERFACE)
target_include_directories(kambara_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(kambara_options INTERFACE -Wall -Wextra -Wconversion -Wshadow -Werror)
if(KAMBARA_SANITIZE)
    target_compile_options(kambara_options INTERFACE
        -fsanitize=${KAMBARA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g
        # gcc 12 takes std::optional's storage for uninitialised once it is instrumented.
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(kambara_options INTERFACE -fsanitize=${KAMBARA_SANITIZE})
endif()

# One OpenCV module a target asks for, its headers as system headers.
function(kambara_use_opencv target)
    target_include_directories(${target} SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS})
    foreach(module IN LISTS ARGN)
        target_link_libraries(${target} PRIVATE opencv_${module})
    endforeach()
endfunction()

# kambara_library(core_camera SOURCES a.cpp ... PUBLIC core_geometry ... PRIVATE yaml-cpp ...)
# One target per second-level folder; the lint test holds its includes to the same edges.
function(kambara_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE;OPENCV" ${ARGN})
    if(ARG_SOURCES)
        add_library(${name} STATIC ${ARG_SOURCES})
        target_link_libraries(${name} PUBLIC kambara_options Eigen3::Eigen ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
        if(ARG_OPENCV)
            kambara_use_opencv(${name} ${ARG_OPENCV})
        endif()
    else()
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE kambara_options Eigen3::Eigen ${ARG_PUBLIC})
    endif()
endfunction()
